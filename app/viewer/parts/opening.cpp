// SPDX-License-Identifier: GPL-3.0-or-later
// Opens molecules and sessions, and describes the open molecule as a session.
#include "app/viewer/parts/opening.hpp"

#include <utility>

#include "app/session/result_header.hpp"
#include "app/viewer/molecule_info.hpp"
#include "app/viewer/resources.hpp"
#include "app/viewer/session_text.hpp"
#include "core/document/fetch/fetch.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"
#include "ui/panels/dialogs/folder_listing.hpp"
#include "ui/panels/dialogs/session_problem.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/number_typing.hpp"

namespace alphascope {

bool Opening::may_open(const std::filesystem::path& path) {
  if (benchmark_busy_()) {  // it uses the open molecule, and reading would disturb its times
    state_.show_error(
        "A benchmark is running",
        path.filename().string() +
            " was not opened. Cancel the benchmark or wait for its end, then open it.",
        ErrorKind::request);
    return false;
  }
  scene_.cameras().set_when_drawn(std::nullopt);
  state_.notice.clear();
  state_.drop_note.clear();
  drop_note_.clear();
  std::error_code ignored;
  // An open file dialog stays in its folder, and no dialog goes to the folder of fetched files.
  if (!state_.browser.show && !id_of_fetched(path) &&
      std::filesystem::is_directory(path.parent_path(), ignored)) {
    state_.browser.folder = path.parent_path();
  }
  return true;
}

void Opening::open(const std::filesystem::path& path) {
  if (looks_like_session(path)) return open_session(path);
  if (!may_open(path)) return;
  forget_waiting_session();
  session_.open(path);
}

void Opening::fetch(const MoleculeId& id, bool again) {
  if (!state_.fetch.problem.empty()) {
    return state_.show_error(id.text() + " cannot be fetched", state_.fetch.problem,
                             ErrorKind::input);
  }
  if (!may_open(id.text())) return;
  forget_waiting_session();
  FetchOptions options = state_.fetch.options;
  options.again = again;
  fetcher_.start(id, options, [this](const std::filesystem::path& file) { open(file); });
}

void Opening::fetch_for_session() {
  if (!waiting_) return;
  const auto id = id_of_fetched(waiting_->read.session.molecule.absolute);
  if (!id || !state_.fetch.problem.empty()) return;
  fetcher_.start(*id, state_.fetch.options, [this](const std::filesystem::path& file) {
    if (waiting_) files_.open_with(waiting_, file);
  });
}

void Opening::open_dropped(const std::vector<std::filesystem::path>& files) {
  const DroppedFiles dropped = choose_dropped(files);
  if (!dropped.opened) return;
  // If a dialog asks for a file, the dropped file is the answer.
  const BrowserPurpose asked = state_.browser.purpose;
  if (asked == BrowserPurpose::molecule || asked == BrowserPurpose::session) {
    state_.browser.show = false;
  }
  open(*dropped.opened);
  if (!benchmark_busy_()) drop_note_ = dropped.note;
  due_.ask();
}

// The note about dropped files, without its first line, which names the opened file.
std::string Opening::not_opened_either() {
  const std::string note = std::exchange(drop_note_, {});
  return note.empty() ? "" : "\n\n" + note.substr(note.find('\n') + 1);
}

void Opening::open_session(const std::filesystem::path& path) {
  forget_waiting_session();
  state_.notice.clear();
  files_.open(path);
}

void Opening::forget_waiting_session() {
  files_.cancel();
  fetcher_.forget();
  waiting_ = starting_ = nullptr;
  awaits_gpu_ = false;
  history_.set_to_restore(std::nullopt);
  if (state_.session_problem) {
    state_.note_withdrawn(state_.session_problem->text, ErrorKind::input);
  }
  state_.session_problem.reset();
}

void Opening::poll() {
  const SessionFiles::Outcome outcome = files_.poll();
  if (!outcome.error.empty()) {
    state_.show_error(outcome.error_title, outcome.error, outcome.error_kind);
  }
  if (awaits_gpu_ && state_.gpu && waiting_) start_session();
  if (outcome.read) {
    waiting_ = outcome.read;
    state_.session_problem.reset();  // a fetched molecule answers the question
    if (waiting_->complete()) {
      start_session();
    } else {
      state_.session_problem = {waiting_->file.string(), waiting_->problem(),
                                waiting_->molecule.state != FoundFile::State::same,
                                waiting_->can_open(), fetchable_id()};
    }
  }
  if (outcome.read || !outcome.error.empty()) due_.ask();
}

// The id by which the missing molecule of the waiting session can be fetched; empty: none.
std::string Opening::fetchable_id() const {
  const FileReference& molecule = waiting_->read.session.molecule;
  if (waiting_->molecule.state != FoundFile::State::missing) return {};
  const auto id = id_of_fetched(molecule.absolute);
  return id && state_.fetch.problem.empty() ? id->text() : std::string();
}

// Replaces an engine that this machine lacks. All engines give the same complex.
Request Opening::possible_here(Request request) const {
  if (needs_gpu(request.engine) && !has_gpu(state_)) request.engine = EngineChoice::automatic;
  return request;
}

void Opening::start_session() {
  const Request& asked = waiting_->read.session.settings.request;
  awaits_gpu_ = needs_gpu(asked.engine) && !state_.gpu;
  if (awaits_gpu_) return;  // the search for a GPU has not ended
  const auto found = std::exchange(waiting_, nullptr);
  if (!may_open(found->file)) return;
  starting_ = found;
  const Settings& settings = found->read.session.settings;
  OpenOptions options = settings.open;
  options.read.max_bytes = state_.settings.open.read.max_bytes;
  if (found->radii_table) options.radii_table = found->radii_table->path;
  session_.open(found->molecule.path, options, canonical(possible_here(settings.request)));
}

// Called when the session's molecule is open, in place of the defaults of a new molecule.
void Opening::show_session() {
  const auto found = std::exchange(starting_, nullptr);
  const SessionDocument& s = found->read.session;
  // Keeps the options with which the molecule was opened.
  OpenOptions open = std::move(state_.settings.open);
  state_.settings.all = s.settings;
  state_.settings.open = std::move(open);
  state_.settings.request = possible_here(s.settings.request);
  state_.window.theme = s.view.light_theme ? Theme::light : Theme::dark;
  state_.playback.alpha = false;
  state_.number = {};
  state_.window.page = s.view.panels.page;
  state_.window.page_height = static_cast<float>(s.view.panels.page_height);
  const auto& closed = s.view.panels.closed_sections;
  state_.window.closed_sections = {closed.begin(), closed.end()};
  state_.window.alpha_slider = s.view.panels.alpha_slider;
  state_.window.picture = s.view.picture;
  static_cast<RecordSettings&>(state_.record) = s.view.recording;
  state_.molecule.radii = grown_radii(*session_.state().prepared, state_.settings.request);
  if (s.view.camera.any()) scene_.cameras().set_when_drawn(s.view.camera);
  state_.session_file = found->file;
  preferences_.ignore_changes_so_far();  // the changes are the session's, not the user's
  if (!found->complete()) {
    state_.drop_note = "These files differ from those of the saved session:\n" + found->problem();
  }
  std::string notes;
  for (const std::string& note : found->read.notes) notes += (notes.empty() ? "" : "\n") + note;
  if (!notes.empty()) {
    state_.show_error("The session has unknown settings",
                      printable(found->file.string()) + "\n\n" + notes +
                          "\n\nAll other settings are restored. A newer version of the program may "
                          "know these.",
                      ErrorKind::input);
  }
}

std::optional<SessionDocument> Opening::document(const std::filesystem::path& file) const {
  const SessionState& s = session_.state();
  if (!s.opened) return std::nullopt;
  SessionDocument document;
  document.written_by = program_text("alphascope");
  document.molecule =
      refer_to(s.opened->molecule->source, s.opened->molecule->sha256, file.parent_path());
  document.settings = history_.settings();
  document.view = window_of_session();
  if (const auto camera = scene_.cameras().place()) document.view.camera = *camera;
  return document;
}

SessionView Opening::window_of_session() const {
  const WindowSettings& w = state_.window;
  return {.light_theme = w.theme == Theme::light,
          .camera = {},
          .panels = {w.page,
                     w.page_height,
                     {w.closed_sections.begin(), w.closed_sections.end()},
                     w.alpha_slider},
          .picture = w.picture,
          .recording = state_.record};
}

void Opening::go_on(const std::filesystem::path& molecule) {
  if (!waiting_) return;
  if (molecule.empty()) return start_session();
  files_.open_with(waiting_, molecule);
}

void Opening::save(const std::filesystem::path& file) {
  const auto written = document(file);
  if (!written) return;
  try {
    files_.save(*written, file, [this, file] {
      state_.session_file = file;
      preferences_.note_recent_file(file);
    });
  } catch (const std::exception& error) {
    state_.show_error("The session cannot be saved", error.what(),
                      kind_of(error, ErrorKind::output));
  }
}

void Opening::start(FoundSession session) {
  forget_waiting_session();
  waiting_ = std::make_shared<const FoundSession>(std::move(session));
  start_session();
}

void Opening::forget_failed() {
  starting_ = nullptr;
  history_.set_to_restore(std::nullopt);
}

std::string Opening::take_drop_note() {
  return std::exchange(drop_note_, {});
}

}  // namespace alphascope
