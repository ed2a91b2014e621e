// SPDX-License-Identifier: GPL-3.0-or-later
// Composes the parts of the window. Takes results of the session into the state, and sends changed
// settings to session and scene.
#include "app/viewer/viewer.hpp"

#include <stdexcept>
#include <utility>

#include "app/session/net_library.hpp"
#include "app/session/result_header.hpp"
#include "app/session/system_memory.hpp"
#include "app/viewer/commands/commands.hpp"
#include "app/viewer/resources.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"

namespace alphascope {
namespace {

// Returns the budget of all large objects, bytes. It is half of the free memory and their own
// together. The other half is for temporary memory, and for other programs.
std::uint64_t large_object_budget(std::uint64_t held) {
  return (available_bytes().value_or(0) + held) / 2;
}

}  // namespace

Viewer::Viewer(Host& host, const ViewerOptions& options, Session::Services services,
               MeshMaker make_mesh, BuiltFonts fonts)
    : host_(host),
      frame_(host, options.light ? Theme::light : Theme::dark, std::move(fonts)),
      scene_([&host] { host.wake(); },
             [mb = options.drawing_memory_mb] { return available_or(mb); }, std::move(make_mesh)),
      queued_(make_queued()),
      preferences_(host, state_, options.preferences),
      jobs_(
          state_, pace_.due(), [&host] { host.wake(); }, services.make_engine),
      store_([&host] { host.wake(); }, [this] { return large_object_budget(store_.held_bytes()); },
             [this] { return session_.threads(); }),
      session_([&host] { host.wake(); }, std::move(services)),
      lessons_(
          {state_, commands_, session_, scene_, file_.opening(), preferences_, history_, sender_,
           pace_.due(), [this] { leave_file(); }},
          [&host] { host.wake(); }, WindowLessons::folders(options.preferences)),
      saving_(
          {host, state_, scene_, session_, store_, inputs_.now(), lessons_.player(), pace_.due()},
          jobs_.list()) {
  jobs_.list_own();
  jobs_.list().add(file_.opening().writer());
  jobs_.list().add(file_.opening().fetcher());
  begin_with(options);
}

Viewer::~Viewer() = default;

void Viewer::begin_with(const ViewerOptions& options) {
  add_program_commands(commands_, state_, calls(), panels_);
  state_.version = ALPHASCOPE_VERSION;
  state_.program = program_named("alphascope");
  state_.samples = sample_files();
  memory_.read();
  preferences_.begin_with(options);
  state_.settings.request.alpha_angstrom2 = options.alpha;
  state_.settings.request.solvent_radius_angstrom = options.solvent;
  state_.settings.request.tetrahedra_only = options.tetrahedra_only;
  state_.window.auto_compare = options.compare;
  if (options.draw_shots_only) draw_shots_only();
  sender_.begin();
  if (const auto preset = preset_named(options.preset)) {
    state_.settings.display = with_preset(state_.settings.display, *preset);
    state_.window.picture = with_preset(state_.window.picture, *preset);
  }
  file_.set_first_objects(options.objects);
  if (options.samples) state_.settings.display.samples = *options.samples;
  sender_.send_look(line_scale());
  history_.restart();
  begin_fetching(options);
  if (options.file) open(*options.file);
  if (options.session) open_session(*options.session);
  if (!options.lesson.empty()) lessons_.open(options.lesson);
}

void Viewer::begin_fetching(const ViewerOptions& options) {
  FetchState& fetch = state_.fetch;
  try {
    fetch.options = fetch_options_of_program();
  } catch (const std::invalid_argument& error) {
    fetch.problem = as_sentence(error.what());
  }
  fetch.options.offline |= options.offline;
  if (options.id) file_.opening().fetch(*options.id, options.fetch_again);
}

bool Viewer::busy() const {
  return working() || jobs_.benchmark().busy() || store_.busy();
}

bool Viewer::working() const {
  return working_except_saving() || saving_.busy() || jobs_.benchmark().exports();
}

bool Viewer::working_except_saving() const {
  const SessionActivity a = session_.activity();
  return !sender_.options_are_sent() || a.opening.busy || a.computing.busy || a.comparing.busy ||
         a.timing.busy || scene_.busy() || scene_.shown().is_due() || jobs_.busy() ||
         file_.opening().busy() || lessons_.busy();
}

void Viewer::take_session() {
  if (jobs_.take_machine() && has_gpu(state_) && !file_.any()) preferences_.take_gpu();
  file_.opening().poll();
  lessons_.poll();
  if (preferences_.poll()) pace_.due().ask();
  jobs_.follow_browser();
  jobs_.follow_guide();
  const SessionChanges changes = session_.poll();
  const SessionState& s = session_.state();
  if (changes.molecule && s.opened) {
    status_.forget_compared();
    memory_.note_freed(file_.take_molecule(line_scale()));
  }
  picture_.follow(changes);
  if (s.ours) {  // otherwise the next answer is being computed
    state_.ours = s.our_timings;
    status_.add_picture_stages();
    state_.cgal = s.reference_timings;
    state_.cgal_parallel = s.parallel_timings;
  }
  OpenOptions before = state_.settings.open;
  if (changes.options) {  // the request failed or was cancelled
    sender_.take_options();
    state_.playback.models = false;
    history_.amend();
  }
  if (changes.error) {
    before.balls.model = state_.settings.open.balls.model;
    take_error(changes.options && before == state_.settings.open);
  }
  if (changes.any()) {
    pace_.due().ask();
    memory_.read();
  }
  status_.update_badge();
  status_.update_cancelled();
  sender_.moves().follow(scene_.drawn().answer, scene_.shown().pacing().finished());
  state_.move_milliseconds = sender_.moves().milliseconds();
}

// Files that are being written of the molecule are cancelled too, except sessions: nobody could
// make them again.
void Viewer::close_file() {
  if (!file_.any()) return;
  for (const JobId job : {JobId::picture, JobId::table, JobId::complex}) jobs_.list().cancel(job);
  leave_file();
}

void Viewer::leave_file() {
  if (!file_.any()) return;
  for (const JobId job : {JobId::fetching, JobId::opening, JobId::computing, JobId::comparing}) {
    jobs_.list().cancel(job);
  }
  file_.close();
  store_.clear();
  status_.forget_compared();
  memory_.note_freed();
  pace_.due().ask();
}

void Viewer::send_controls() {
  sender_.send_request();
  sender_.send_selection();
  sender_.send_look(line_scale());
  state_.settings.selection.note_order();
  history_.note_changes(state_.playback.alpha || state_.playback.models || lessons_.plays() ||
                        saving_.sweeps());
}

}  // namespace alphascope
