// SPDX-License-Identifier: GPL-3.0-or-later
// Saves pictures, recordings, tables and exports on request. At most one job of each kind runs.
#pragma once

#include <functional>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/jobs/file_job.hpp"
#include "app/viewer/jobs/job_list.hpp"
#include "app/viewer/lessons/lesson_player.hpp"
#include "app/viewer/lessons/lesson_recorder.hpp"
#include "app/viewer/saving/picture_saver.hpp"
#include "app/viewer/saving/sweep_recorder.hpp"
#include "app/viewer/saving/table_saver.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

struct ExportRequest;

class SaveJobs {
 public:
  struct Parts {  // of the window; they must outlive this
    Host& host;
    ViewState& state;
    SceneController& scene;
    Session& session;
    Store& store;
    const Inputs& inputs;  // of the picture
    LessonPlayer& lessons;
    DueFrames& due;
  };
  // Adds its jobs to `jobs`.
  SaveJobs(const Parts& parts, JobList& jobs);

  void save_picture(const ScreenshotRequest& request);
  // A sweep sets alpha itself. The window stays unchanged, unless pages draw into the picture.
  void record(const RecordRequest& request);
  void save_table(const SaveTableRequest& request);
  void export_complex(const ExportRequest& request);

  // Call once a frame, for recordings that use the window itself. `quiet`: no other work is
  // running.
  void go_on_recording(bool quiet);
  bool records_window() const { return lesson_.busy() || sweep_.busy(); }
  bool sweeps() const { return sweep_.busy(); }
  bool busy() const;

 private:
  void tell(const char* title, const std::exception& error);
  SweepRecorder::Window swept_window();

  Parts p_;
  PictureSaver pictures_;
  TableSaver tables_;
  FileJob exports_{JobId::complex, [this] { p_.host.wake(); }};
  LessonRecorder lesson_;
  SweepRecorder sweep_;
};

}  // namespace alphascope
