// The running program: one host, one session, one scene, and the loop that ties them to the panels.
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

  // Until the user quits. Draws only when something changed.
  void run();

  // One step for scripts and tests: takes in results, draws one frame with this input.
  void step(ScriptedInput* input);
  // Waits until the last frame is drawn, also where a GPU draws.
  void finish_frame();
  // Milliseconds: SceneController::picture_stages().
  const std::vector<StageTime>& picture_stages() const { return scene_.picture_stages(); }
  // Takes in results until the next frame may be drawn; whether anything happened.
  bool wait_for_frame();
  // A molecule, a complex, a comparison or a mesh is on its way.
  bool busy() const;
  // Pictures are drawn while the window goes on, as on a GPU, by OpenGL in software as well.
  void draw_meanwhile() { scene_.draw_meanwhile(); }
  // From now on the panels of other frames than shoot()'s are made and not drawn.
  void draw_shots_only() { draw_shots_only_ = true; }
  // Draws the scene as finely as it can be, then the window, into a PNG file.
  void shoot(const std::filesystem::path& path, ScriptedInput* input);

  // A molecule, or a session by its name.
  void open(const std::filesystem::path& path) { opening_.open(path); }
  void open_session(const std::filesystem::path& path) { opening_.open_session(path); }
  // One of them; what becomes of the others is told.
  void open_dropped(const std::vector<std::filesystem::path>& files) {
    opening_.open_dropped(files);
  }
  bool quit_requested() const { return quit_; }

  // Of what was set: molecule options, alpha, solvent radius, engine, display, selection.
  void undo() { history_.undo(); }
  void redo() { history_.redo(); }

  ViewState& state() { return state_; }
  Calls calls();  // queued until the end of the frame
  const Commands& commands() const { return commands_; }
  const WidgetRects& widgets() const { return rects_; }
  PanelSet& panels() { return panels_; }
  Session& session() { return session_; }
  Host& host() { return host_; }
  // Values of one derived result, since the start.
  std::uint64_t times_made(std::string_view id) const { return store_.times_made(id); }

 private:
  using Clock = std::chrono::steady_clock;

  void fill_constants();
  class Stage;   // of lessons
  class Queued;  // calls
  std::shared_ptr<Queued> make_queued();
  std::unique_ptr<LessonStage> make_lesson_stage();
  static std::vector<std::filesystem::path> lesson_folders(const ViewerOptions& options);
  void take_lesson_files();
  // Runs what may throw on the main thread; what it throws is shown, and the program goes on.
  void guarded(const std::function<void()>& what);
  void take_error(bool only_the_model_changed);
  void take_session();  // results and failures into the state
  // As busy(), but for a benchmark: frames drawn meanwhile would be in its times.
  bool working() const;
  bool all_but_saving() const;  // of that
  void take_machine();
  void take_molecule();
  void take_file();  // what another file begins with
  void close_dialogs_of_file();
  void start_preset();
  void take_answer();
  void take_results();
  double seconds_to_next_frame() const;
  void take_derived();
  bool needs_filtration() const;
  void want_of_all_balls();  // triangulation and filtration, in the background
  void poll_store();
  bool may_take_inputs(const Answer& shown) const;
  void take_inputs(const std::shared_ptr<const Answer>& shown);
  void note_large_objects();  // for the store's budget
  void take_shown();          // what is said of the picture changes with it
  void run_calls();           // what the panels asked for
  void cancel_computing();
  void send_controls();  // changed controls to session and scene
  void send_look();      // to the scene
  bool awaits_panels() const;
  bool waits_for_tables();
  void send_compute();
  void send_selection();
  bool settled() const;  // the latest request is answered
  void colour_by_what_differs(const Molecule& molecule);
  void read_memory();
  void give_back_memory_when_due();
  bool interacting() const;
  void draw(ScriptedInput* input, bool patient,
            const std::function<void(unsigned)>& before_swap = {});
  double idle_seconds() const;

  Host& host_;
  ViewState state_;
  Commands commands_;  // on state_
  WidgetRects rects_;
  PanelSet panels_;
  ImGuiFrame frame_;
  SceneController scene_;
  ShownMarks marks_{state_, scene_};
  Pointing pointing_{state_, scene_, marks_, frame_};
  Request sent_compute_;
  OpenOptions sent_open_;
  std::shared_ptr<const Molecule> shown_file_;  // as deposited
  std::optional<Clock::time_point> tooltip_due_;
  Clock::time_point selection_sent_at_{};
  ColourBy automatic_colour_ = ColourBy::chain;
  DueFrames due_;
  Playing playing_{state_, session_, scene_, due_};
  bool quit_ = false;
  bool patient_ = false;
  bool draw_shots_only_ = false;
  bool must_render_ = false;          // the picture of what state_.result says
  bool memory_to_give_back_ = false;  // something large was freed
  FolderReader folder_reader_;
  std::shared_ptr<Queued> queued_;
  WindowPreferences preferences_;
  LessonFiles lesson_files_;
  std::unique_ptr<LessonStage> lesson_stage_;
  LessonPlayer lessons_;
  SaveJobs saving_;
  std::future<MachineInfo> machine_;  // looking for a GPU can take a second
  Benchmark benchmark_;
  Inputs inputs_;  // of derived results
  Clock::time_point inputs_taken_at_{};
  Clock::time_point frame_begun_at_{};
  bool news_ = false;  // something has come that no frame shows
  bool picture_is_new_ = false;
  std::shared_ptr<const Answer> source_;  // whose balls they are; null: there are none
  std::uint64_t balls_seen_ = 0, bodies_seen_ = 0, frames_key_ = 0;
  std::shared_ptr<const PreparedBalls> body_;  // the last of bodies_seen_
  Store store_;
  Session session_;  // after what its threads wake; before the classes below, which use it
  History history_{state_, session_, scene_};
  WorkStatus status_{state_, session_, scene_, store_};
  Opening opening_{host_,    state_,       scene_, session_,
                   history_, preferences_, due_,   [this] { return benchmark_.busy(); }};
};

}  // namespace alphascope
