// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the jobs that save pictures, recordings, tables and exports.
#include "app/viewer/saving/save_jobs.hpp"

#include <stdexcept>

#include "core/document/export/complex_export.hpp"
#include "core/document/settings/request.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

constexpr const char* kNoTable = "The table cannot be saved";
constexpr const char* kNoExport = "The complex cannot be exported";

// Moves the camera back until the picture shows as much of the width as the window. A lesson's
// picture beside its text is narrower than the window, in which the view was chosen. A wider angle
// would distort what the view shows. `least_aspect`: the window's, as in Viewpoint.
Picture with_sides(Picture picture, const ViewportInfo& window, const PictureOptions& size,
                   double least_aspect) {
  if (picture.viewpoint) picture.viewpoint->least_aspect = least_aspect;
  if (!picture.viewpoint || window.height <= 0 || size.width <= 0) return picture;
  const double back = static_cast<double>(window.width) / window.height * size.height / size.width;
  if (!(back > 1)) return picture;
  Viewpoint& view = *picture.viewpoint;
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] + back * (view.position[k] - view.focal_point[k]);
  }
  return picture;
}

// Writes all files of an export or none. Returns a text on their content.
std::string write_complex(const Answer& answer, const ComplexHeader& header,
                          const ExportRequest& request, const RunContext& context) {
  const ExportFormatInfo* const format = export_format_of(request.path);
  if (format == nullptr) throw std::runtime_error("No format has this ending.");
  const ExportSource source{answer, *answer.molecule, *answer.prepared, header, request.colours};
  std::vector<std::string> lines;
  write_together(
      export_files(*format, request.path),
      [&](const std::vector<AtomicFile*>& files) {
        lines = write_export(source, *format, request.path, files, context);
      },
      context.cancel);
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? ": " : "; ") + line;
  return text;
}

}  // namespace

SaveJobs::SaveJobs(const Parts& parts, JobList& jobs)
    : p_(parts),
      pictures_(parts.host, [&host = parts.host] { host.wake(); }),
      tables_([&host = parts.host] { host.wake(); }, parts.store, parts.inputs),
      lesson_(parts.lessons, parts.state.lessons, pictures_,
              [this](const ScreenshotRequest& r) {
                const double least = p_.scene.shown().canvas().scene().viewpoint().least_aspect;
                return with_sides(p_.scene.picture(r), p_.state.viewport, r.options, least);
              }),
      sweep_(pictures_, swept_window()) {
  jobs.add(pictures_);
  jobs.add(tables_);
  jobs.add(exports_);
}

bool SaveJobs::busy() const {
  return pictures_.busy() || tables_.running() || exports_.busy() || records_window();
}

void SaveJobs::tell(const char* title, const std::exception& error) {
  p_.state.show_error(title, error.what(), kind_of(error, ErrorKind::computing));
}

void SaveJobs::save_picture(const ScreenshotRequest& request) {
  try {
    pictures_.start(picture_job(p_.scene.picture(request)));
    p_.state.notice.clear();
  } catch (const std::exception& error) {
    tell(request.path.empty() ? kNoCopy : kNoPicture, error);
  }
  p_.due.ask();
}

SweepRecorder::Window SaveJobs::swept_window() {
  return {[this](const ScreenshotRequest& r) { return p_.scene.picture(r); },
          [this](const Alpha& angstrom2) { set_alpha(p_.state.settings.request, angstrom2); },
          [this] { return p_.state.settings.request.alpha_angstrom2; },
          [this]() -> std::optional<Alpha> {
            const auto& answer = p_.scene.drawn().answer;
            if (!answer) return std::nullopt;
            return answer->request.alpha_angstrom2;
          },
          [this]() -> const void* { return p_.session.state().opened.get(); }};
}

// Records the molecule, radii, display and view on screen. A sweep sets alpha itself. The window
// does not change, unless pages draw into the picture.
void SaveJobs::record(const RecordRequest& request) {
  try {
    if (request.lesson_seconds) {
      lesson_.start(request, p_.state.window.theme);
    } else if (request.recording.kind == RecordingKind::sweep &&
               !p_.scene.picture({request.path, request.options}).layers.empty()) {
      sweep_.start(request, p_.scene.texts());
    } else {
      pictures_.start(recording_job(request, p_.scene.frames(request), p_.scene.texts()));
    }
    p_.state.notice.clear();
  } catch (const std::exception& error) {
    tell(kNoRecording, error);
  }
  p_.due.ask();
}

void SaveJobs::go_on_recording(bool quiet) {
  if (!lesson_.busy() && !sweep_.busy()) return;
  const std::string no_lesson = lesson_.step(quiet);
  if (!no_lesson.empty()) {
    p_.state.show_error("The lesson was not recorded", no_lesson, ErrorKind::computing);
  }
  const std::string no_sweep = sweep_.step(quiet);
  if (!no_sweep.empty()) {
    p_.state.show_error("The sweep was not recorded", no_sweep, ErrorKind::computing);
  }
  p_.due.ask();
}

void SaveJobs::save_table(const SaveTableRequest& request) {
  try {
    tables_.start(request);
    p_.state.notice.clear();
  } catch (const std::exception& error) {
    tell(kNoTable, error);
  }
  p_.due.ask();
}

// Exports the complex on screen, even while a newer one is being computed.
void SaveJobs::export_complex(const ExportRequest& request) {
  try {
    const std::shared_ptr<const Answer> answer = p_.scene.drawn().answer;
    if (!answer) throw std::runtime_error("There is no complex yet.");
    exports_.start(
        {request.path, "Exporting " + request.path.filename().string(), kNoExport,
         [answer, header = p_.scene.drawn().header(), request](const RunContext& context) {
           return write_complex(*answer, header, request, context);
         }});
    p_.session.release_engine_memory();
    p_.state.notice.clear();
  } catch (const std::exception& error) {
    tell(kNoExport, error);
  }
  p_.due.ask();
}

}  // namespace alphascope
