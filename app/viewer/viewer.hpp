// SPDX-License-Identifier: GPL-3.0-or-later
// The running window: one host, one session, one scene, and the loop that connects them with the
// panels.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/session/session.hpp"
#include "app/viewer/frames/frame_pace.hpp"
#include "app/viewer/frames/frame_picture.hpp"
#include "app/viewer/frames/picture_inputs.hpp"
#include "app/viewer/frames/settings_sender.hpp"
#include "app/viewer/jobs/window_jobs.hpp"
#include "app/viewer/lessons/window_lessons.hpp"
#include "app/viewer/mouse/pointing.hpp"
#include "app/viewer/options.hpp"
#include "app/viewer/parts/history.hpp"
#include "app/viewer/parts/memory_watch.hpp"
#include "app/viewer/parts/message_notes.hpp"
#include "app/viewer/parts/playing.hpp"
#include "app/viewer/parts/shown_file.hpp"
#include "app/viewer/parts/shown_marks.hpp"
#include "app/viewer/parts/window_preferences.hpp"
#include "app/viewer/parts/work_status.hpp"
#include "app/viewer/saving/save_jobs.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/store/store.hpp"
#include "ui/calls.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/whole_state.hpp"
#include "ui/widgets/widget_rects.hpp"
#include "ui/window/host.hpp"
#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Viewer {
 public:
  Viewer(Host& host, const ViewerOptions& options,
         Session::Services services = Session::program_services(),
         MeshMaker make_mesh = &build_mesh, BuiltFonts fonts = {});
  ~Viewer();

  // Runs until the user quits. Draws only when something has changed.
  void run();

  // One step for scripts and tests: takes in results, then draws one frame with this input.
  void step(ScriptedInput* input);
  // Waits until the last frame is drawn, on a GPU as well.
  void finish_frame();
  // Times in milliseconds, as in Pacing::stages().
  const std::vector<StageTime>& picture_stages() const { return scene_.shown().pacing().stages(); }
  // Takes in results until the next frame may be drawn. Returns whether anything happened.
  bool wait_for_frame();
  // True while any work is unfinished: opening, computing, comparing, drawing, derived results,
  // files being written, the search for a GPU, or a benchmark.
  bool busy() const;
  // Draws pictures in the background with software OpenGL too, as with a GPU.
  void render_asynchronously() { scene_.render_asynchronously(); }
  // From now on panels are drawn only in the frames of shoot().
  void draw_shots_only() { frame_.draw_shots_only(); }
  // Draws the scene at the finest quality, then the window, into a PNG file.
  void shoot(const std::filesystem::path& path, ScriptedInput* input);

  // A molecule or, by the name's ending, a session.
  void open(const std::filesystem::path& path) { file_.opening().open(path); }
  void open_session(const std::filesystem::path& path) { file_.opening().open_session(path); }
  // Opens one of the files and notes why the others are not opened.
  void open_dropped(const std::vector<std::filesystem::path>& files) {
    file_.opening().open_dropped(files);
  }
  bool quit_requested() const;
  void undo() { history_.undo(); }
  void redo() { history_.redo(); }

  ViewState& state() { return state_; }
  Calls calls();  // they wait until the panels of the frame are drawn
  const Commands& commands() const { return commands_; }
  const WidgetRects& widgets() const { return rects_; }
  PanelSet& panels() { return panels_; }
  Session& session() { return session_; }
  Host& host() { return host_; }
  // How often one derived result has been made since the start.
  std::uint64_t times_made(std::string_view id) const { return store_.times_made(id); }

 private:
  class Queued;  // the queued calls
  std::shared_ptr<Queued> make_queued();
  void begin_with(const ViewerOptions& options);
  void begin_fetching(const ViewerOptions& options);
  // Runs `what` on the main thread. An exception is shown to the user, and the program goes on.
  void guarded(const std::function<void()>& what);
  float line_scale() const { return preferences_.line_scale(frame_.scale()); }
  // As busy(), without the benchmark and derived results. A benchmark alone causes no frames, since
  // drawing would disturb its times.
  bool working() const;
  bool working_except_saving() const;  // working(), without files being saved
  void take_results();
  void take_session();  // moves results and failures of the session into the state
  void take_error(bool only_the_model_changed);
  void close_file();     // closes the molecule
  void leave_file();     // the same, and what is being saved goes on
  void run_calls();      // makes the calls of the panels
  void send_controls();  // hands changed controls to session and scene
  void draw(ScriptedInput* input, const std::function<void(unsigned)>& before_swap = {});
  void move_camera(bool scripted);  // a step of a glide
  void act();                       // does what the panels and the mouse ask for
  bool frame_is_due() const;

  Host& host_;
  WholeState state_;
  Commands commands_;  // act on state_
  WidgetRects rects_;
  PanelSet panels_;
  ImGuiFrame frame_;
  SceneController scene_;
  ShownMarks marks_{state_, scene_};
  Pointing pointing_{state_, scene_, marks_, frame_};
  FramePace pace_;
  MemoryWatch memory_{state_, pace_.due()};
  Playing playing_{state_, session_, scene_, pace_.due()};
  std::shared_ptr<Queued> queued_;
  WindowPreferences preferences_;
  WindowJobs jobs_;
  Store store_;
  Session session_;  // after what its threads wake; before the classes below, which use it
  FramePicture picture_{{host_, state_, frame_, scene_, store_, session_, pace_.due()}};
  PictureInputs inputs_{state_, session_, scene_, marks_, store_, pace_.due()};
  SettingsSender sender_{state_, session_, scene_, store_, inputs_, pace_.due()};
  History history_{state_, session_, scene_};
  ShownFile file_{{host_, state_, session_, scene_, preferences_, history_, sender_, pace_.due()},
                  [this] { return jobs_.benchmark().busy(); }};
  MessageNotes messages_{state_};
  WorkStatus status_{state_, session_, scene_, store_, file_.opening(), jobs_.list()};
  WindowLessons lessons_;
  SaveJobs saving_;
};

}  // namespace alphascope
