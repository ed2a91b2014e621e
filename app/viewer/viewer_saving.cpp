// Saving pictures, tables and exports: started here, done elsewhere.
#include "app/viewer/viewer.hpp"
#include "ui/widgets/controls.hpp"

namespace alphascope {
namespace {

constexpr const char* kNoPicture = "The picture cannot be saved";
constexpr const char* kNoRecording = "The recording cannot be made";

}  // namespace

void Viewer::save_picture(const ScreenshotRequest& request) {
  try {
    saver_.start(picture_job(scene_.picture(request)));
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell(kNoPicture, error.what());
  }
  frames_due_ = kSettlingFrames;
}

SweepRecorder::Window Viewer::swept_window() {
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

// Of what is on screen: molecule, radii, display and view; a sweep says alpha itself. The window
// stays as it is, unless pages draw into the picture.
void Viewer::record(const RecordRequest& request) {
  try {
    if (request.lesson_seconds) {
      lesson_recorder_.start(request, state_.window.theme);
    } else if (request.recording.kind == RecordingKind::sweep &&
               !scene_.picture({request.path, request.options}).layers.empty()) {
      sweep_recorder_.start(request, scene_.texts());
    } else {
      saver_.start(recording_job(request, scene_.frames(request), scene_.texts()));
    }
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell(kNoRecording, error.what());
  }
  frames_due_ = kSettlingFrames;
}

void Viewer::go_on_recording() {
  if (!lesson_recorder_.busy() && !sweep_recorder_.busy()) return;
  const bool quiet = !all_but_saving() && !store_.busy();
  const std::string no_lesson = lesson_recorder_.step(quiet);
  if (!no_lesson.empty()) state_.tell("The lesson was not recorded", no_lesson);
  const std::string no_sweep = sweep_recorder_.step(quiet);
  if (!no_sweep.empty()) state_.tell("The sweep was not recorded", no_sweep);
  frames_due_ = kSettlingFrames;
}

void Viewer::save_table(const SaveTableRequest& request) {
  try {
    table_saver_.start(request);
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The table cannot be saved", error.what());
  }
  frames_due_ = kSettlingFrames;
}

// Of the complex on screen, not of one that is being computed.
void Viewer::export_complex(const ExportRequest& request) {
  try {
    if (!scene_.drawn_answer()) throw std::runtime_error("There is no complex yet.");
    complex_saver_.start(scene_.drawn_answer(), scene_.header(), request);
    session_.let_engines_rest();
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The complex cannot be exported", error.what());
  }
  frames_due_ = kSettlingFrames;
}

// The one whose line is shown.
void Viewer::cancel_saving() {
  if (saver_.busy()) return saver_.cancel();
  if (table_saver_.busy()) return table_saver_.cancel(store_);
  complex_saver_.cancel();
}

void Viewer::take_saved() {
  const PictureSaver::Outcome outcome = saver_.poll();
  const ComplexSaver::Outcome exported = complex_saver_.poll();
  if (!outcome.notice.empty()) state_.notice = outcome.notice;
  if (!exported.notice.empty()) state_.notice = exported.notice;
  if (!outcome.error.empty()) {
    state_.tell(outcome.of_recording ? kNoRecording : kNoPicture, outcome.error);
  }
  if (!exported.error.empty()) state_.tell("The complex cannot be exported", exported.error);
  saver_.describe(state_.saving);
  if (!state_.saving.active) table_saver_.describe(state_.saving);
  if (!state_.saving.active) complex_saver_.describe(state_.saving);
  if (!outcome.any() && !exported.any()) return;
  frames_due_ = kSettlingFrames;
  memory_to_give_back_ = true;
}

}  // namespace alphascope
