// What the window writes on request: pictures, recordings, tables and exports. One of each kind
// runs at a time; ViewState::saving shows the first of them.
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
  // A sweep says alpha itself. The window stays as it is, unless pages draw into the picture.
  void record(const RecordRequest& request);
  void save_table(const SaveTableRequest& request);
  void export_complex(const ExportRequest& request);
  void cancel();  // the one whose line is shown

  // Once a frame, for what the window itself goes through. `quiet`: nothing else is on its way.
  void go_on_recording(bool quiet);
  bool records_window() const { return lesson_.busy() || sweep_.busy(); }
  bool sweeps() const { return sweep_.busy(); }
  // Takes what is finished, and describes what goes on; true: memory was given back.
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
