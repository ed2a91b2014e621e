// The running window: one host, one session, one scene, and the loop that connects them with the
// panels.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>

#include "app/session/machine.hpp"
#include "app/session/session.hpp"
#include "app/viewer/jobs/benchmark.hpp"
#include "app/viewer/jobs/folder_reader.hpp"
#include "app/viewer/jobs/save_jobs.hpp"
#include "app/viewer/lessons/lesson_files.hpp"
#include "app/viewer/lessons/lesson_player.hpp"
#include "app/viewer/options.hpp"
#include "app/viewer/parts/due_frames.hpp"
#include "app/viewer/parts/history.hpp"
#include "app/viewer/parts/opening.hpp"
#include "app/viewer/parts/playing.hpp"
#include "app/viewer/parts/pointing.hpp"
#include "app/viewer/parts/shown_marks.hpp"
#include "app/viewer/parts/window_preferences.hpp"
#include "app/viewer/parts/work_status.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/store/store.hpp"
#include "ui/calls.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widget_rects.hpp"
#include "ui/window/host.hpp"
#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Viewer {
 public:
  Viewer(Host& host, const ViewerOptions& options,
         Session::Services services = Session::program_services(),
         SceneController::MeshMaker make_mesh = &build_mesh);
  ~Viewer();

  // Runs until the user quits. Draws only when something has changed.
  void run();

  // One step for scripts and tests: takes in results, then draws one frame with this input.
  void step(ScriptedInput* input);
  // Waits until the last frame is drawn, on a GPU as well.
  void finish_frame();
  // Times in milliseconds, as in SceneController::picture_stages().
  const std::vector<StageTime>& picture_stages() const { return scene_.picture_stages(); }
  // Takes in results until the next frame may be drawn. Returns whether anything happened.
  bool wait_for_frame();
  // True while a molecule, a complex, a comparison or a mesh is being made.
  bool busy() const;
  // Draws pictures in the background with software OpenGL too, as with a GPU.
  void draw_meanwhile() { scene_.draw_meanwhile(); }
  // From now on panels are drawn only in the frames of shoot().
  void draw_shots_only() { draw_shots_only_ = true; }
  // Draws the scene at the finest quality, then the window, into a PNG file.
  void shoot(const std::filesystem::path& path, ScriptedInput* input);

  // A molecule or, by the name's ending, a session.
  void open(const std::filesystem::path& path) { opening_.open(path); }
  void open_session(const std::filesystem::path& path) { opening_.open_session(path); }
  // Opens one of the files and notes why the others are not opened.
  void open_dropped(const std::vector<std::filesystem::path>& files) {
    opening_.open_dropped(files);
  }
  bool quit_requested() const { return quit_; }

  // The history holds molecule options, alpha, solvent radius, engine, display and selection.
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
  using Clock = std::chrono::steady_clock;

  void fill_constants();
  class Stage;   // the window as a lesson's player sees it
  class Queued;  // the queued calls
  std::shared_ptr<Queued> make_queued();
  std::unique_ptr<LessonStage> make_lesson_stage();
  static std::vector<std::filesystem::path> lesson_folders(const ViewerOptions& options);
  void take_lesson_files();
  // Runs `what` on the main thread. An exception is shown to the user, and the program goes on.
  void guarded(const std::function<void()>& what);
  void take_error(bool only_the_model_changed);
  void take_session();  // moves results and failures of the session into the state
  // As busy(), without the benchmark. Frames drawn during a benchmark would be in its times.
  bool working() const;
  bool all_but_saving() const;  // working(), without files being saved
  void take_machine();
  void take_molecule();
  void take_file();  // sets the state that begins with each new file
  void close_dialogs_of_file();
  void start_preset();
  void take_answer();
  void take_results();
  double seconds_to_next_frame() const;
  void take_derived();
  bool needs_filtration() const;
  void want_of_all_balls();  // wants triangulation and filtration of all balls, in the background
  void poll_store();
  bool may_take_inputs(const Answer& shown) const;
  void take_inputs(const std::shared_ptr<const Answer>& shown);
  void note_large_objects();  // reports their bytes to the store's budget
  void take_shown();          // updates the texts about the picture
  void run_calls();           // makes the calls of the panels
  void cancel_computing();
  void send_controls();  // hands changed controls to session and scene
  void send_look();      // hands the display settings to the scene
  bool awaits_panels() const;
  bool waits_for_tables();
  void send_compute();
  void send_selection();
  bool settled() const;  // true when the latest request is answered
  void colour_by_what_differs(const Molecule& molecule);
  void read_memory();
  void give_back_memory_when_due();
  bool interacting() const;
  void draw(ScriptedInput* input, bool patient,
            const std::function<void(unsigned)>& before_swap = {});
  double idle_seconds() const;

  Host& host_;
  ViewState state_;
  Commands commands_;  // act on state_
  WidgetRects rects_;
  PanelSet panels_;
  ImGuiFrame frame_;
  SceneController scene_;
  ShownMarks marks_{state_, scene_};
  Pointing pointing_{state_, scene_, marks_, frame_};
  Request sent_compute_;
  OpenOptions sent_open_;
  std::shared_ptr<const Molecule> shown_file_;  // the molecule as deposited
  std::optional<Clock::time_point> tooltip_due_;
  Clock::time_point selection_sent_at_{};
  ColourBy automatic_colour_ = ColourBy::chain;
  DueFrames due_;
  Playing playing_{state_, session_, scene_, due_};
  bool quit_ = false;
  bool patient_ = false;
  bool draw_shots_only_ = false;
  bool must_render_ = false;          // state_.result is not yet in the picture
  bool memory_to_give_back_ = false;  // a large object was freed
  FolderReader folder_reader_;
  std::shared_ptr<Queued> queued_;
  WindowPreferences preferences_;
  LessonFiles lesson_files_;
  std::unique_ptr<LessonStage> lesson_stage_;
  LessonPlayer lessons_;
  SaveJobs saving_;
  std::future<MachineInfo> machine_;  // in the background: the search for a GPU can take a second
  Benchmark benchmark_;
  Inputs inputs_;  // inputs of derived results
  Clock::time_point inputs_taken_at_{};
  Clock::time_point frame_begun_at_{};
  bool news_ = false;  // results have arrived that no frame shows yet
  bool picture_is_new_ = false;
  std::shared_ptr<const Answer> source_;  // the owner of the balls in inputs_; null: none
  std::uint64_t balls_seen_ = 0, bodies_seen_ = 0, frames_key_ = 0;
  std::shared_ptr<const PreparedBalls> body_;  // the body that bodies_seen_ counted last
  Store store_;
  Session session_;  // after what its threads wake; before the classes below, which use it
  History history_{state_, session_, scene_};
  WorkStatus status_{state_, session_, scene_, store_};
  Opening opening_{host_,    state_,       scene_, session_,
                   history_, preferences_, due_,   [this] { return benchmark_.busy(); }};
};

}  // namespace alphascope
