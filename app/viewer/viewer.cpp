// Composes the parts of the window. Takes results of the session into the state, and sends changed
// settings to session and scene.
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
#include "core/document/store/derived.hpp"
#include "core/run/freed_elsewhere.hpp"
#include "core/run/freed_memory.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

// The budget of all large objects, bytes: half of the sum of free memory and their own. The rest is
// for temporary memory while they are made, and for other programs.
std::uint64_t large_object_budget(std::uint64_t held) {
  return (available_bytes().value_or(0) + held) / 2;
}

// While the slider of models moves, a model that is being computed may finish, so that pictures
// keep coming. The next request waits for it no longer than this.
constexpr std::chrono::milliseconds kModelGrace{300};

}  // namespace

Viewer::Viewer(Host& host, const ViewerOptions& options, Session::Services services,
               SceneController::MeshMaker make_mesh)
    : host_(host),
      frame_(host, options.light ? Theme::light : Theme::dark),
      scene_([&host] { host.wake(); },
             [mb = options.drawing_memory_mb] { return available_or(mb); }, std::move(make_mesh)),
      folder_reader_([&host] { host.wake(); }),
      queued_(make_queued()),
      preferences_(host, state_, options.preferences),
      lesson_files_([&host] { host.wake(); }, lesson_folders(options)),
      lesson_stage_(make_lesson_stage()),
      lessons_(*lesson_stage_, state_.lessons),
      saving_(host, state_, scene_, session_, store_, lessons_, due_),
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
  preferences_.begin_with(options);
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
  scene_.set_display(state_.settings.display, state_.window.theme,
                     preferences_.line_scale(frame_.scale()));
  history_.restart();
  if (options.file) opening_.open(*options.file);
  if (options.session) opening_.open_session(*options.session);
  if (!options.lesson.empty()) lesson_files_.open(options.lesson);
}

Viewer::~Viewer() = default;

void Viewer::fill_constants() {
  state_.version = ALPHASCOPE_VERSION;
  state_.program = program_named("alphascope");
  state_.memory_bytes = resident_bytes();
  state_.samples = sample_files();
}

bool Viewer::busy() const {
  return working() || benchmark_.busy() || store_.busy();
}

bool Viewer::working() const {
  return all_but_saving() || saving_.busy();
}

bool Viewer::all_but_saving() const {
  const SessionActivity a = session_.activity();
  return state_.settings.open != sent_open_ || a.opening.busy || a.computing.busy ||
         a.comparing.busy || a.timing.busy || !state_.gpu || scene_.busy() ||
         folder_reader_.busy() || opening_.busy() || lesson_files_.busy() || lessons_.busy();
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
  status_.forget_compared();
  if (new_molecule) {
    memory_to_give_back_ = true;  // that of the previous molecule
    colour_by_what_differs(*s.molecule);
    if (shown_file_ != s.opened->deposited) take_file();
    send_look();  // colours and looks that the molecule decides, before its first picture
  }
  // A new selection of the same molecule keeps the last result on screen until its own is there.
  scene_.set_molecule(s.opened);
}

void Viewer::take_file() {
  const SessionState& s = session_.state();
  shown_file_ = s.opened->deposited;
  state_.drop_note = opening_.take_drop_note();
  host_.set_title(state_.molecule.name + " – Alphascope");
  close_dialogs_of_file();
  state_.cavities.wanted_row.reset();
  state_.playback.models = false;
  state_.steps.playing = false;
  sent_open_ = session_.open_options();
  state_.settings = {
      .open = sent_open_, .request = state_.settings.request, .display = state_.settings.display};
  state_.expression_error.reset();
  state_.memory.expression_typed = state_.memory.expression_shown =
      state_.settings.open.balls.selection;
  const auto session = opening_.starting();
  const std::filesystem::path& source = s.opened->deposited->source;
  const bool of_session = session && session->molecule.path == source;
  state_.session_file.clear();
  if (!of_session || session->is_recent) {
    preferences_.note_recent_file(of_session && !session->file.empty() ? session->file : source);
  }
  if (of_session) {
    opening_.show_session();
    sent_compute_ = state_.settings.request;
  }
  start_preset();
  history_.restart();
  if (of_session) history_.take_back();
}

// Closes dialogs about the previous file.
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
    due_.ask();
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
  if (has_gpu(state_) && !shown_file_) preferences_.take_gpu();
  due_.ask();
}

void Viewer::take_session() {
  take_machine();
  memory_to_give_back_ |= saving_.poll();
  opening_.poll();
  take_lesson_files();
  if (preferences_.poll()) due_.ask();
  state_.listing = folder_reader_.listing(wanted_listing(state_.memory));
  if (benchmark_.busy() && benchmark_.poll(state_.benchmark)) {
    due_.ask();
    memory_to_give_back_ |= !benchmark_.busy();
  }
  const SessionChanges changes = session_.poll();
  const SessionState& s = session_.state();
  if (changes.molecule && s.opened) take_molecule();
  if (changes.answer && s.ours) take_answer();
  if (s.prepared && !s.ours && !session_.activity().computing.busy) {
    scene_.show_without_answer();  // the computation was cancelled or has failed
  }
  if (changes.agreement && s.agreement) scene_.set_agreement(s.agreement);
  if (s.ours) {  // otherwise the next answer is being computed
    state_.ours = s.our_timings;
    status_.add_picture_stages();
    state_.cgal = s.reference_timings;
    state_.cgal_parallel = s.parallel_timings;
  }
  OpenOptions before = state_.settings.open;
  if (changes.options) {  // the request failed or was cancelled
    state_.settings.open = sent_open_ = session_.open_options();
    state_.playback.models = false;
    history_.amend();
  }
  if (changes.error) {
    before.balls.model = state_.settings.open.balls.model;
    take_error(changes.options && before == state_.settings.open);
  }
  if (changes.any()) {
    due_.ask();
    read_memory();
  }
  status_.update_badge();
}

void Viewer::read_memory() {
  state_.memory_bytes = resident_bytes();
  state_.free_bytes = available_bytes().value_or(0);
}

// Waits for the end of a computation, which would allocate the memory again.
void Viewer::give_back_memory_when_due() {
  if (!memory_to_give_back_ || busy() || interacting()) return;
  memory_to_give_back_ = false;
  wait_until_freed();
  give_back_freed_memory();
  read_memory();
  due_.ask();
}

// Colours by element where there is only one chain. A colour that the user has chosen stays.
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

// Called twice a frame: before the panels for changes by commands, after them for changes by
// panels.
void Viewer::send_compute() {
  if (state_.settings.request == sent_compute_ || awaits_panels()) return;
  sent_compute_ = state_.settings.request;
  session_.set_request(canonical(state_.settings.request), of_all_balls(store_, inputs_));
  state_.compute_error.clear();  // the message was about another alpha
  const SessionState& s = session_.state();
  if (s.prepared) state_.molecule.radii = grown_radii(*s.prepared, state_.settings.request);
  due_.ask();
}

void Viewer::send_controls() {
  send_compute();
  send_selection();
  send_look();
  state_.settings.selection.note_order();
  history_.note_changes(state_.playback.alpha || state_.playback.models || lessons_.busy() ||
                        saving_.sweeps());
}

void Viewer::send_look() {
  scene_.set_display(state_.settings.display, state_.window.theme,
                     preferences_.line_scale(frame_.scale()));
  scene_.set_clip(state_.settings.clip);
  scene_.set_appearance(state_.settings.appearance);
}

// With software OpenGL the processor that draws a frame also makes the tables of this picture.
// While a slider is dragged, the frame waits for the tables, so that both appear together. The next
// frame does not wait.
bool Viewer::waits_for_tables() {
  const bool new_picture = std::exchange(picture_is_new_, false);
  return new_picture && frame_.in_software() && interacting() && store_.busy(Lane::interactive);
}

// While the solvent radius is dragged, the engine runs at most one step ahead of the tables of all
// balls. Otherwise the computations would take all cores, and the tables would fall behind.
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
      // The typed expression stays in its field, so that it can be corrected.
      state_.memory.expression_shown = wanted.balls.selection;
    }
  }
  if (wanted == sent_open_) return;
  OpenOptions as_frames = sent_open_;  // a slider or a dragged ball changes model and sandbox often
  as_frames.balls.model = wanted.balls.model;
  as_frames.sandbox = wanted.sandbox;
  const bool may_wait = wanted == as_frames && !settled() && state_.error.empty() &&
                        Clock::now() - selection_sent_at_ < kModelGrace;
  if (may_wait) return;
  // Copies of chains have other names in another assembly, and copies of models hold other atoms.
  if (wanted.assembly != sent_open_.assembly) wanted.balls.without_chains.clear();
  sent_open_ = wanted;
  selection_sent_at_ = Clock::now();
  session_.set_open_options(wanted);
  due_.ask();
}

// Starts editing the preset of the sandbox that was opened for it.
void Viewer::start_preset() {
  SandboxMemory& m = state_.memory.sandbox;
  m.pixels_per_angstrom = 0;
  const std::filesystem::path wanted = std::exchange(m.edit_when_open, {});
  const SessionState& s = session_.state();
  if (wanted.empty() || wanted != s.opened->deposited->source) return;
  if (!state_.settings.open.sandbox) state_.settings.open.sandbox = sandbox_of(*s.prepared->balls);
}

}  // namespace alphascope
