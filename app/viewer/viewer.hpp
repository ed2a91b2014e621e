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
#include "app/viewer/ball_drag.hpp"
#include "app/viewer/gestures.hpp"
#include "app/viewer/hit_text.hpp"
#include "app/viewer/jobs/benchmark.hpp"
#include "app/viewer/jobs/complex_saver.hpp"
#include "app/viewer/jobs/folder_reader.hpp"
#include "app/viewer/jobs/picture_saver.hpp"
#include "app/viewer/jobs/preferences_keeper.hpp"
#include "app/viewer/jobs/session_files.hpp"
#include "app/viewer/jobs/sweep_recorder.hpp"
#include "app/viewer/jobs/table_saver.hpp"
#include "app/viewer/lessons/lesson_files.hpp"
#include "app/viewer/lessons/lesson_player.hpp"
#include "app/viewer/lessons/lesson_recorder.hpp"
#include "app/viewer/model_playback.hpp"
#include "app/viewer/options.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/session/editor.hpp"
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
  void open(const std::filesystem::path& path);
  void open_session(const std::filesystem::path& path);
  // One of them; what becomes of the others is told.
  void open_dropped(const std::vector<std::filesystem::path>& files);
  bool quit_requested() const { return quit_; }

  // Of what was set: molecule options, alpha, solvent radius, engine, display, selection.
  void undo();
  void redo();

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
  // ImGui needs a frame or two after the last input until everything has settled (hover, popups).
  static constexpr int kSettlingFrames = 3;

  void fill_constants();
  bool may_open(const std::filesystem::path& path);  // tells why not; forgets notes of the last
  void forget_waiting_session();
  void take_session_files();
  Request possible_here(Request request) const;
  void start_session();  // waiting_session_
  void show_session();   // starting_session_
  class Stage;           // of lessons
  class Queued;          // calls
  std::shared_ptr<Queued> make_queued();
  std::unique_ptr<LessonStage> make_lesson_stage();
  static std::vector<std::filesystem::path> lesson_folders(const ViewerOptions& options);
  void take_lesson_files();
  void take_back_history();
  // None without a molecule.
  std::optional<SessionDocument> session_document(const std::filesystem::path& file) const;
  SessionView window_of_session() const;  // without the camera
  void use_preferences(const ViewerOptions& options);
  Preferences preferred() const;
  void note_preferences();
  void note_recent_file(const std::filesystem::path& file);
  void forget_recent();
  void follow_scale();
  float line_scale() const;
  void poll_preferences();
  // Runs what may throw on the main thread; what it throws is shown, and the program goes on.
  void guarded(const std::function<void()>& what);
  std::string not_opened_either();
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
  SweepRecorder::Window swept_window();
  void save_picture(const ScreenshotRequest& request);
  void record(const RecordRequest& request);
  void go_on_recording();  // once a frame: what the window itself goes through
  void save_table(const SaveTableRequest& request);
  void export_complex(const ExportRequest& request);
  void cancel_saving();
  void take_saved();
  void send_controls();  // changed controls to session and scene
  void send_look();      // to the scene
  bool awaits_panels() const;
  void add_picture_stages();
  bool waits_for_tables();
  void send_compute();
  void send_selection();
  Settings settings() const;  // as the controls have them
  void note_changes();        // into the history
  void show_settings();       // the history's, in the controls
  void note_view();           // that the program has moved: undo brings it back
  void bring_view_back(const CameraPlace& view, bool other_atoms);
  bool settled() const;  // the latest request is answered
  void update_busy();
  void update_badge();
  void colour_by_what_differs(const Molecule& molecule);
  bool compares_by_itself() const;
  void compare_when_due();
  struct UnderMouse {
    std::optional<Ref> what;  // none: a body of a panel's, which hides what is behind it
    HitText text;
  };
  std::optional<UnderMouse> under(int x, int y) const;  // pixels of the picture
  UnderMouse under_atom(std::size_t atom) const;        // of the molecule
  void follow_picture();                                // state_.references
  std::shared_ptr<const BallReferences> references_of(const Answer& answer) const;
  void describe_under_mouse();
  void click(const PointerEvent& event);
  bool drag_ball(const PointerEvent& event);  // of a sandbox in space; whether it is one of that
  std::optional<std::size_t> sandbox_ball_at(int x, int y) const;
  void open_context_menu();  // of what is under the mouse
  void mark_selection();
  std::optional<std::size_t> place_beside(const Ref& item) const;
  void find_marks();
  SceneController::Selected drawn_of(const RefSet& items) const;
  void zoom_to(const RefSet& items);
  void centre_on(const RefSet& items);
  bool is_drawn(std::size_t atom) const;  // of the molecule, by index
  void draw_annotations();
  void place_clip_handle();
  void save_view(const std::string& name);  // in place of one of that name
  void go_to_view(const std::string& name);
  void read_memory();
  void give_back_memory_when_due();
  void play();
  void play_models();
  void play_steps();
  bool interacting() const;
  void draw(ScriptedInput* input, bool patient,
            const std::function<void(unsigned)>& before_swap = {});
  double idle_seconds() const;
  double seconds_to_next_step() const;

  Host& host_;
  ViewState state_;
  Commands commands_;  // on state_
  WidgetRects rects_;
  PanelSet panels_;
  ImGuiFrame frame_;
  SceneController scene_;
  Request sent_compute_;
  OpenOptions sent_open_;
  std::shared_ptr<const Molecule> shown_file_;  // as deposited
  std::string drop_note_when_open_;             // of the file that is being read
  struct Marked {                               // of the selection, and of what the marks were made
    RefSet items;
    std::shared_ptr<const BallReferences> references;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<const LayerMesh> beside;
    Theme theme = Theme::dark;
    SceneController::Selected drawn;
    std::shared_ptr<const Layer> layer;  // null: no simplex
    std::uint64_t key = 0;
  };
  Marked marked_;
  struct Annotated {  // what was written into the picture last, and of what that was made
    Annotations annotations;
    std::shared_ptr<const BallReferences> references;
    std::shared_ptr<const BallSet> balls;
    std::shared_ptr<const BallAppearance> looks;
    std::shared_ptr<const LayerMesh> beside;
    Theme theme = Theme::dark;
    std::shared_ptr<const Layer> layer;  // null: nothing
    std::uint64_t key = 0;
  };
  Annotated annotated_;
  std::shared_ptr<const Answer> compared_;  // the last answer for which a comparison was asked
  std::optional<Clock::time_point> busy_since_, comparing_since_, tooltip_due_;
  Clock::time_point selection_sent_at_{};
  ModelPlayback model_playback_, step_playback_;
  std::optional<BallDrag> ball_drag_;
  Editor editor_;
  // A view that the program moved for an entry of the history: where it was before, and, once that
  // is undone, after it.
  struct MovedView {
    CameraPlace before;
    std::optional<CameraPlace> after;
    std::uint64_t moves = 0;  // view_moves_ then
  };
  std::map<std::size_t, MovedView> moved_views_;  // by the number of the entry, from 1
  std::optional<CameraPlace> view_before_requests_;
  Gesture entry_gesture_ = 0;     // of the last entry
  std::uint64_t view_moves_ = 0;  // that somebody asked for, by hand or in words
  Gestures gestures_;
  Gesture gesture_ = 0;                              // of this frame
  std::optional<std::array<double, 3>> clip_pivot_;  // while the handle is held
  ColourBy automatic_colour_ = ColourBy::chain;
  int frames_due_ = 3;
  bool quit_ = false;
  bool patient_ = false;
  bool draw_shots_only_ = false;
  bool must_render_ = false;          // the picture of what state_.result says
  bool memory_to_give_back_ = false;  // something large was freed
  PictureSaver saver_;
  TableSaver table_saver_;
  ComplexSaver complex_saver_;
  FolderReader folder_reader_;
  SessionFiles session_files_;
  // Read, and not decided upon; then with its molecule on its way. Null: none.
  std::shared_ptr<const FoundSession> waiting_session_, starting_session_;
  bool session_awaits_gpu_ = false;
  std::shared_ptr<Queued> queued_;
  PreferencesKeeper preferences_;
  LessonFiles lesson_files_;
  std::unique_ptr<LessonStage> lesson_stage_;
  LessonPlayer lessons_;
  LessonRecorder lesson_recorder_;
  SweepRecorder sweep_recorder_;
  std::optional<Editor> history_to_come_back_;  // of the session that is on its way
  Preferences noted_;                     // as the window had them when they were looked at last
  double set_scale_ = 0, set_times_ = 1;  // of the host
  std::optional<EngineChoice> engine_when_found_;  // preferred, and in need of a GPU
  std::future<MachineInfo> machine_;               // looking for a GPU can take a second
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
  Session session_;  // last: its threads wake the host
};

}  // namespace alphascope
