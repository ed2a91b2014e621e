// Saves pictures, recordings, tables and exports on request. At most one job of each kind runs;
// ViewState::saving shows the first.
#pragma once

#include <functional>

#include "app/session/session.hpp"
#include "app/viewer/jobs/complex_saver.hpp"
#include "app/viewer/jobs/picture_saver.hpp"
#include "app/viewer/jobs/sweep_recorder.hpp"
#include "app/viewer/jobs/table_saver.hpp"
#include "app/viewer/lessons/lesson_player.hpp"
#include "app/viewer/lessons/lesson_recorder.hpp"
#include "app/viewer/parts/due_frames.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

class SaveJobs {
 public:
  SaveJobs(Host& host, ViewState& state, SceneController& scene, Session& session, Store& store,
           LessonPlayer& lessons, DueFrames& due);

  void save_picture(const ScreenshotRequest& request);
  // A sweep sets alpha itself. The window stays unchanged, unless pages draw into the picture.
  void record(const RecordRequest& request);
  void save_table(const SaveTableRequest& request);
  void export_complex(const ExportRequest& request);
  void cancel();  // cancels the job whose line of progress is shown

  // Call once a frame, for recordings that use the window itself. `quiet`: no other work is
  // running.
  void go_on_recording(bool quiet);
  bool records_window() const { return lesson_.busy() || sweep_.busy(); }
  bool sweeps() const { return sweep_.busy(); }
  // Takes in finished jobs and describes the running ones. True: memory was freed.
  bool poll();
  void poll_tables(const Inputs& inputs);
  bool busy() const {
    return pictures_.busy() || tables_.busy() || complexes_.busy() || records_window();
  }

 private:
  SweepRecorder::Window swept_window();

  ViewState& state_;
  SceneController& scene_;
  Session& session_;
  Store& store_;
  DueFrames& due_;
  PictureSaver pictures_;
  TableSaver tables_;
  ComplexSaver complexes_;
  LessonRecorder lesson_;
  SweepRecorder sweep_;
};

}  // namespace alphascope
