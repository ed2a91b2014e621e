// Starts the jobs that save pictures, recordings, tables and exports, and collects their outcomes.
#include "app/viewer/jobs/save_jobs.hpp"

#include <stdexcept>

#include "ui/widgets/controls.hpp"

namespace alphascope {
namespace {

constexpr const char* kNoPicture = "The picture cannot be saved";
constexpr const char* kNoTable = "The table cannot be saved";
constexpr const char* kNoRecording = "The recording cannot be made";

// Moves the camera back until the picture shows as much width as the window. A lesson's view was
// chosen in the window, and the picture beside its text is narrower.
Picture with_sides(Picture picture, const ViewportInfo& window, const PictureOptions& size) {
  if (!picture.viewpoint || window.height <= 0 || size.width <= 0) return picture;
  const double back = static_cast<double>(window.width) / window.height * size.height / size.width;
  if (!(back > 1)) return picture;
  Viewpoint& view = *picture.viewpoint;
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] + back * (view.position[k] - view.focal_point[k]);
  }
  return picture;
}

}  // namespace

SaveJobs::SaveJobs(Host& host, ViewState& state, SceneController& scene, Session& session,
                   Store& store, LessonPlayer& lessons, DueFrames& due)
    : state_(state),
      scene_(scene),
      session_(session),
      store_(store),
      due_(due),
      pictures_(host, [&host] { host.wake(); }),
      tables_([&host] { host.wake(); }),
      complexes_([&host] { host.wake(); }),
      lesson_(lessons, state.lessons, pictures_,
              [this](const ScreenshotRequest& r) {
                return with_sides(scene_.picture(r), state_.viewport, r.options);
              }),
      sweep_(pictures_, swept_window()) {}

void SaveJobs::save_picture(const ScreenshotRequest& request) {
  try {
    pictures_.start(picture_job(scene_.picture(request)));
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell(kNoPicture, error.what());
  }
  due_.ask();
}

SweepRecorder::Window SaveJobs::swept_window() {
  return {[this](const ScreenshotRequest& r) { return scene_.picture(r); },
          [this](const Alpha& angstrom2) { set_alpha(state_.settings.request, angstrom2); },
          [this] { return state_.settings.request.alpha_angstrom2; },
          [this]() -> std::optional<Alpha> {
            const auto& answer = scene_.drawn_answer();
            if (!answer) return std::nullopt;
            return answer->request.alpha_angstrom2;
          },
          [this]() -> const void* { return session_.state().opened.get(); }};
}

// Records molecule, radii, display and view that are on screen; a sweep sets alpha itself. The
// window stays unchanged, unless pages draw into the picture.
void SaveJobs::record(const RecordRequest& request) {
  try {
    if (request.lesson_seconds) {
      lesson_.start(request, state_.window.theme);
    } else if (request.recording.kind == RecordingKind::sweep &&
               !scene_.picture({request.path, request.options}).layers.empty()) {
      sweep_.start(request, scene_.texts());
    } else {
      pictures_.start(recording_job(request, scene_.frames(request), scene_.texts()));
    }
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell(kNoRecording, error.what());
  }
  due_.ask();
}

void SaveJobs::go_on_recording(bool quiet) {
  if (!lesson_.busy() && !sweep_.busy()) return;
  const std::string no_lesson = lesson_.step(quiet);
  if (!no_lesson.empty()) state_.tell("The lesson was not recorded", no_lesson);
  const std::string no_sweep = sweep_.step(quiet);
  if (!no_sweep.empty()) state_.tell("The sweep was not recorded", no_sweep);
  due_.ask();
}

void SaveJobs::save_table(const SaveTableRequest& request) {
  try {
    tables_.start(request);
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell(kNoTable, error.what());
  }
  due_.ask();
}

// Exports the complex on screen, not one that is being computed.
void SaveJobs::export_complex(const ExportRequest& request) {
  try {
    if (!scene_.drawn_answer()) throw std::runtime_error("There is no complex yet.");
    complexes_.start(scene_.drawn_answer(), scene_.header(), request);
    session_.let_engines_rest();
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The complex cannot be exported", error.what());
  }
  due_.ask();
}

// Cancels the job whose line of progress is shown.
void SaveJobs::cancel() {
  if (pictures_.busy()) return pictures_.cancel();
  if (tables_.busy()) return tables_.cancel(store_);
  complexes_.cancel();
}

bool SaveJobs::poll() {
  const PictureSaver::Outcome outcome = pictures_.poll();
  const ComplexSaver::Outcome exported = complexes_.poll();
  if (!outcome.notice.empty()) state_.notice = outcome.notice;
  if (!exported.notice.empty()) state_.notice = exported.notice;
  if (!outcome.error.empty()) {
    state_.tell(outcome.of_recording ? kNoRecording : kNoPicture, outcome.error);
  }
  if (!exported.error.empty()) state_.tell("The complex cannot be exported", exported.error);
  pictures_.describe(state_.saving);
  if (!state_.saving.active) tables_.describe(state_.saving);
  if (!state_.saving.active) complexes_.describe(state_.saving);
  if (!outcome.any() && !exported.any()) return false;
  due_.ask();
  return true;
}

void SaveJobs::poll_tables(const Inputs& inputs) {
  const TableSaver::Outcome saved = tables_.poll(store_, inputs);
  if (!saved.notice.empty()) state_.notice = saved.notice;
  if (!saved.error.empty()) state_.tell(kNoTable, saved.error);
  if (saved.any()) due_.ask();
}

}  // namespace alphascope
