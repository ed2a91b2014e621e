// See the header.
#include "app/viewer/viewer.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/result_header.hpp"
#include "app/session/system_memory.hpp"
#include "app/viewer/commands/commands.hpp"
#include "app/viewer/molecule_info.hpp"
#include "app/viewer/resources.hpp"
#include "app/viewer/state_bridge.hpp"
#include "core/document/settings/display_preset.hpp"
#include "core/run/freed_elsewhere.hpp"
#include "core/run/freed_memory.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

// Of all large objects: half of what there is, with what they already hold. The rest is for what
// they take while they are made, and for other programs.
std::uint64_t large_object_budget(std::uint64_t held) {
  return (available_bytes().value_or(0) + held) / 2;
}

// A model asked for by the slider lets the one before it be finished, so that pictures flow while
// the hand moves, but not for longer than this.
constexpr std::chrono::milliseconds kModelGrace{300};

// Beside a lesson's text the picture is narrower than in the window, where the lesson was made to
// look right: the camera steps back until it has both sides.
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

Viewer::Viewer(Host& host, const ViewerOptions& options, Session::Services services,
               SceneController::MeshMaker make_mesh)
    : host_(host),
      frame_(host, options.light ? Theme::light : Theme::dark),
      scene_([&host] { host.wake(); },
             [mb = options.drawing_memory_mb] { return available_or(mb); }, std::move(make_mesh)),
      saver_(host, [&host] { host.wake(); }),
      table_saver_([&host] { host.wake(); }),
      complex_saver_([&host] { host.wake(); }),
      folder_reader_([&host] { host.wake(); }),
      session_files_([&host] { host.wake(); }),
      queued_(make_queued()),
      preferences_([&host] { host.wake(); }, options.preferences),
      lesson_files_([&host] { host.wake(); }, lesson_folders(options)),
      lesson_stage_(make_lesson_stage()),
      lessons_(*lesson_stage_, state_.lessons),
      lesson_recorder_(lessons_, state_.lessons, saver_,
                       [this](const ScreenshotRequest& r) {
                         return with_sides(scene_.picture(r), state_.viewport, r.options);
                       }),
      sweep_recorder_(saver_, swept_window()),
      machine_(std::async(std::launch::async,
                          [&host] {
                            const MachineInfo& machine = machine_info();
                            host.wake();
                            return machine;
                          })),
      benchmark_([&host] { host.wake(); }, services.make_engine),
      store_([&host] { host.wake(); }, [this] { return large_object_budget(store_.held_bytes()); },
             [this] { return session_.threads(); }),
      session_([&host] { host.wake(); }, std::move(services)) {
  add_program_commands(commands_, state_, calls());
  fill_constants();
  set_scale_ = options.scale;
  use_preferences(options);
  state_.settings.request.alpha_angstrom2 = options.alpha;
  state_.settings.request.solvent_radius_angstrom = options.solvent;
  state_.settings.request.tetrahedra_only = options.tetrahedra_only;
  state_.window.auto_compare = options.compare;
  draw_shots_only_ = options.draw_shots_only;
  sent_compute_ = state_.settings.request;
  session_.set_request(canonical(state_.settings.request));
  session_.set_open_options(state_.settings.open);
  if (const auto preset = preset_named(options.preset)) {
    state_.settings.display = with_preset(state_.settings.display, *preset);
  }
  if (options.samples) state_.settings.display.samples = *options.samples;
  scene_.set_display(state_.settings.display, state_.window.theme, line_scale());
  editor_.restart(settings());
  if (options.file) open(*options.file);
  if (options.session) open_session(*options.session);
  if (!options.lesson.empty()) lesson_files_.open(options.lesson);
}

Viewer::~Viewer() = default;

void Viewer::fill_constants() {
  state_.version = ALPHASCOPE_VERSION;
  state_.program = program_named("alphascope");
  state_.memory_bytes = resident_bytes();
  state_.samples = sample_files();
}

bool Viewer::may_open(const std::filesystem::path& path) {
  if (benchmark_.busy()) {  // it is of the open molecule, and would measure the reading too
    state_.tell("A benchmark is running",
                path.filename().string() +
                    " was not opened. Cancel the benchmark or wait for its end, then open it.");
    return false;
  }
  scene_.set_camera_when_drawn(std::nullopt);
  state_.notice.clear();
  state_.drop_note.clear();
  drop_note_when_open_.clear();
  std::error_code ignored;
  // The file dialog stays where it is while it is open.
  if (!state_.memory.show_browser && std::filesystem::is_directory(path.parent_path(), ignored)) {
    state_.memory.browser_folder = path.parent_path();
  }
  return true;
}

void Viewer::open(const std::filesystem::path& path) {
  if (looks_like_session(path)) return open_session(path);
  if (!may_open(path)) return;
  forget_waiting_session();
  session_.open(path);
}

void Viewer::open_dropped(const std::vector<std::filesystem::path>& files) {
  const DroppedFiles dropped = choose_dropped(files);
  if (!dropped.opened) return;
  // It is an answer to the dialog that asks for one.
  const BrowserPurpose asked = state_.memory.browser_purpose;
  if (asked == BrowserPurpose::molecule || asked == BrowserPurpose::session) {
    state_.memory.show_browser = false;
  }
  open(*dropped.opened);
  if (!benchmark_.busy()) drop_note_when_open_ = dropped.note;
  frames_due_ = kSettlingFrames;
}

bool Viewer::busy() const {
  return working() || benchmark_.busy() || store_.busy();
}

bool Viewer::working() const {
  return all_but_saving() || saver_.busy() || table_saver_.busy() || complex_saver_.busy() ||
         lesson_recorder_.busy() || sweep_recorder_.busy();
}

bool Viewer::all_but_saving() const {
  const SessionActivity a = session_.activity();
  return state_.settings.open != sent_open_ || a.opening.busy || a.computing.busy ||
         a.comparing.busy || a.timing.busy || !state_.gpu || scene_.busy() ||
         folder_reader_.busy() || session_files_.busy() || lesson_files_.busy() || lessons_.busy();
}

bool Viewer::settled() const {
  const SessionActivity a = session_.activity();
  return !a.opening.busy && !a.computing.busy && session_.state().up_to_date();
}

void Viewer::take_molecule() {
  const SessionState& s = session_.state();
  const bool new_molecule = scene_.molecule() != s.molecule;
  state_.molecule = describe_molecule(*s.opened);
  state_.molecule.radii = grown_radii(*s.prepared, state_.settings.request);
  compared_ = nullptr;
  if (new_molecule) {
    memory_to_give_back_ = true;  // the last one's
    colour_by_what_differs(*s.molecule);
    if (shown_file_ != s.opened->deposited) take_file();
    send_look();  // all that is decided by the molecule: its first picture has it
  }
  // Another selection of the same molecule leaves the last result on screen until its own is there.
  scene_.set_molecule(s.opened);
}

void Viewer::take_file() {
  const SessionState& s = session_.state();
  shown_file_ = s.opened->deposited;
  state_.drop_note = std::exchange(drop_note_when_open_, {});
  host_.set_title(state_.molecule.name + " – Alphascope");
  close_dialogs_of_file();
  state_.cavities.wanted_row.reset();
  state_.playback.models = state_.memory.timings_pinned = false;
  state_.steps.playing = false;
  sent_open_ = session_.open_options();
  state_.settings = {
      .open = sent_open_, .request = state_.settings.request, .display = state_.settings.display};
  state_.expression_error.reset();
  state_.memory.expression_typed = state_.memory.expression_shown =
      state_.settings.open.balls.selection;
  const auto& session = starting_session_;
  const std::filesystem::path& source = s.opened->deposited->source;
  const bool of_session = session && session->molecule.path == source;
  state_.session_file.clear();
  if (!of_session || session->is_recent) {
    note_recent_file(of_session && !session->file.empty() ? session->file : source);
  }
  if (of_session) show_session();
  start_preset();
  editor_.restart(settings());
  if (of_session) take_back_history();
}

// What they ask about is not open any more.
void Viewer::close_dialogs_of_file() {
  PanelMemory& m = state_.memory;
  m.saving.names.clear();
  const bool any = m.show_save || m.show_export || m.show_save_session || m.record.show ||
                   m.save_table.table || !m.confirm_assembly.empty();
  if (!any) return;
  m.show_save = m.show_export = m.show_save_session = m.record.show = false;
  m.save_table.table = nullptr;
  m.save_path.clear();
  m.export_path.clear();
  m.record.path.clear();
  if (m.browser_purpose == BrowserPurpose::save) m.show_browser = false;
  m.confirm_assembly.clear();
  state_.notice = "The dialog was closed, for another file was opened.";
}

void Viewer::take_answer() {
  const SessionState& s = session_.state();
  scene_.set_answer(s.ours);
  state_.device_text = s.ours->complex.engine.name + " on " + s.ours->complex.engine.device;
  state_.engine_note = s.ours->note;
}

void Viewer::take_shown() {
  must_render_ |= scene_.poll();
  scene_.describe(state_.viewport);
  if (state_.result != scene_.drawn_answer()) {
    state_.result = scene_.drawn_answer();
    frames_due_ = kSettlingFrames;
    news_ = picture_is_new_ = true;
  }
  const auto& ours = session_.state().ours;
  state_.pending = ours && ours != state_.result ? pending_text(*ours) : "";
}

void Viewer::take_machine() {
  if (state_.gpu || machine_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  state_.gpu = machine_.get().gpu;
  if (engine_when_found_ && has_gpu(state_) && !shown_file_) {
    state_.settings.request.engine = noted_.engine = *engine_when_found_;
  }
  frames_due_ = kSettlingFrames;
}

void Viewer::take_session() {
  take_machine();
  take_saved();
  take_session_files();
  take_lesson_files();
  poll_preferences();
  state_.listing = folder_reader_.listing(wanted_listing(state_.memory));
  if (benchmark_.busy() && benchmark_.poll(state_.benchmark)) {
    frames_due_ = kSettlingFrames;
    memory_to_give_back_ |= !benchmark_.busy();
  }
  const SessionChanges changes = session_.poll();
  const SessionState& s = session_.state();
  if (changes.molecule && s.opened) take_molecule();
  if (changes.answer && s.ours) take_answer();
  if (s.prepared && !s.ours && !session_.activity().computing.busy) {
    scene_.show_without_answer();  // cancelled or failed
  }
  if (changes.agreement && s.agreement) scene_.set_agreement(s.agreement);
  if (s.ours) {  // else the next answer is on its way
    state_.ours = s.our_timings;
    add_picture_stages();
    state_.cgal = s.reference_timings;
    state_.cgal_parallel = s.parallel_timings;
  }
  OpenOptions before = state_.settings.open;
  if (changes.options) {  // what was asked for failed or was cancelled
    state_.settings.open = sent_open_ = session_.open_options();
    state_.playback.models = false;
    editor_.amend(settings());
  }
  if (changes.error) {
    before.balls.model = state_.settings.open.balls.model;
    take_error(changes.options && before == state_.settings.open);
  }
  if (changes.any()) {
    frames_due_ = kSettlingFrames;
    read_memory();
  }
  update_badge();
}

void Viewer::read_memory() {
  state_.memory_bytes = resident_bytes();
  state_.free_bytes = available_bytes().value_or(0);
}

// Not while something is computed, which takes it again.
void Viewer::give_back_memory_when_due() {
  if (!memory_to_give_back_ || busy() || interacting()) return;
  memory_to_give_back_ = false;
  wait_until_freed();
  give_back_freed_memory();
  read_memory();
  frames_due_ = kSettlingFrames;
}

// Chains say nothing when there is only one; then elements do. A choice of the user's stays.
void Viewer::colour_by_what_differs(const Molecule& molecule) {
  DisplayControls& d = state_.settings.display;
  const Paint automatic{automatic_colour_, {}, {}, {}};
  if (d.ball_paint != automatic || d.complex_paint != automatic) return;
  const bool one_chain =
      std::all_of(molecule.atoms.begin(), molecule.atoms.end(),
                  [&](const Atom& a) { return a.chain == molecule.atoms.front().chain; });
  automatic_colour_ = one_chain ? ColourBy::element : ColourBy::chain;
  d.ball_paint = d.complex_paint = {automatic_colour_, {}, {}, {}};
}

// What a command has set, before the panels; what they have set, after them.
void Viewer::send_compute() {
  if (state_.settings.request == sent_compute_ || awaits_panels()) return;
  sent_compute_ = state_.settings.request;
  session_.set_request(canonical(state_.settings.request));
  state_.compute_error.clear();  // of another alpha; it may be told again
  const SessionState& s = session_.state();
  if (s.prepared) state_.molecule.radii = grown_radii(*s.prepared, state_.settings.request);
  frames_due_ = kSettlingFrames;
}

void Viewer::send_controls() {
  send_compute();
  send_selection();
  send_look();
  state_.settings.selection.note_order();
  note_changes();
}

void Viewer::send_look() {
  scene_.set_display(state_.settings.display, state_.window.theme, line_scale());
  scene_.set_clip(state_.settings.clip);
  scene_.set_appearance(state_.settings.appearance);
}

// A frame is drawn by the processor that also makes the tables of this picture. While a hand
// slides, both come to the screen in one frame, unless the tables take long: the next frame is
// drawn anyway.
bool Viewer::waits_for_tables() {
  const bool new_picture = std::exchange(picture_is_new_, false);
  return new_picture && frame_.in_software() && interacting() && store_.busy(Lane::interactive);
}

// While a hand slides the solvent radius, the engine is at most one step ahead of what panels make
// of all balls: else pictures took the cores, and tables would fall behind.
bool Viewer::awaits_panels() const {
  const auto& ours = session_.state().ours;
  const bool other_balls =
      state_.settings.request.solvent_radius_angstrom != sent_compute_.solvent_radius_angstrom;
  const bool ahead = session_.activity().computing.busy || (ours && ours->balls != inputs_.balls);
  return other_balls && ahead && interacting() && store_.busy(Lane::interactive);
}

void Viewer::send_selection() {
  OpenOptions& wanted = state_.settings.open;
  if (wanted.balls.selection != sent_open_.balls.selection) {
    state_.expression_error = fault_of_selection(wanted.balls.selection);
    if (state_.expression_error) {
      wanted.balls.selection = sent_open_.balls.selection;
      // What was typed stays, to be mended.
      state_.memory.expression_shown = wanted.balls.selection;
    }
  }
  if (wanted == sent_open_) return;
  OpenOptions as_frames = sent_open_;  // what a slider or a dragged ball changes often
  as_frames.balls.model = wanted.balls.model;
  as_frames.sandbox = wanted.sandbox;
  const bool may_wait = wanted == as_frames && !settled() && state_.error.empty() &&
                        Clock::now() - selection_sent_at_ < kModelGrace;
  if (may_wait) return;
  // Copies of chains have other names, and copies of models other atoms.
  if (wanted.assembly != sent_open_.assembly) wanted.balls.without_chains.clear();
  sent_open_ = wanted;
  selection_sent_at_ = Clock::now();
  session_.set_open_options(wanted);
  frames_due_ = kSettlingFrames;
}

// The next step is asked for when the last one is on screen, however long that took.
void Viewer::play() {
  bool& playing = state_.playback.alpha;
  if (!playing || !session_.state().up_to_date() || scene_.busy()) return;
  const NextAlpha next =
      next_alpha(state_.window.alpha_slider, state_.settings.request.alpha_angstrom2,
                 state_.playback.backwards);
  if (next.ended) {
    playing = false;
    return;
  }
  set_alpha(state_.settings.request, next.alpha);
  frames_due_ = kSettlingFrames;
}

// As play(): a model is asked for when the last one is on screen, and its time is over.
void Viewer::play_models() {
  if (!state_.playback.models) {
    model_playback_.stop();
    return;
  }
  int& model = state_.settings.open.balls.model;
  const ModelPlayback::Scene scene{
      model, static_cast<int>(state_.molecule.models.size()),
      settled() && !scene_.busy() && state_.settings.open == sent_open_};
  if (const auto next =
          model_playback_.next(scene, state_.playback.models_per_second, Clock::now())) {
    model = *next;
    frames_due_ = kSettlingFrames;
  }
}

// As play_models(), but not beyond the last one, and no frame is drawn before the next is due.
void Viewer::play_steps() {
  StepsMemory& memory = state_.steps;
  const bool over = memory.current && memory.at() == memory.last();
  if (over || state_.window.page != kStepsPage) memory.playing = false;
  if (!memory.playing) {
    step_playback_.stop();
    return;
  }
  const ModelPlayback::Scene scene{static_cast<int>(memory.at()), static_cast<int>(memory.count()),
                                   memory.current && !scene_.busy()};
  if (const auto next = step_playback_.next(scene, memory.a_second, Clock::now())) {
    memory.show(static_cast<std::size_t>(*next));
    frames_due_ = kSettlingFrames;
  }
}

}  // namespace alphascope
