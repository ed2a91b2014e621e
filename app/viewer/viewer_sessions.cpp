// Opening and saving sessions: what is read waits here until its molecule is open, so that whatever
// goes wrong on the way leaves the window as it is.
#include <utility>

#include "app/session/result_header.hpp"
#include "app/viewer/molecule_info.hpp"
#include "app/viewer/viewer.hpp"
#include "core/text/printable.hpp"

namespace alphascope {

void Viewer::open_session(const std::filesystem::path& path) {
  forget_waiting_session();
  state_.notice.clear();
  session_files_.open(path);
}

void Viewer::forget_waiting_session() {
  session_files_.cancel();
  waiting_session_ = starting_session_ = nullptr;
  session_awaits_gpu_ = false;
  history_to_come_back_.reset();
  state_.session_problem.reset();
}

void Viewer::take_session_files() {
  const SessionFiles::Outcome outcome = session_files_.poll();
  if (!outcome.error.empty()) state_.tell(outcome.error_title, outcome.error);
  if (outcome.saved) {
    state_.session_file = *outcome.saved;
    state_.notice = "Saved " + printable(outcome.saved->string());
    note_recent_file(*outcome.saved);
  }
  if (session_awaits_gpu_ && state_.gpu && waiting_session_) start_session();
  if (outcome.read) {
    waiting_session_ = outcome.read;
    if (waiting_session_->complete()) {
      start_session();
    } else {
      state_.session_problem = {waiting_session_->file.string(), waiting_session_->problem(),
                                waiting_session_->molecule.state != FoundFile::State::same,
                                waiting_session_->can_open()};
    }
  }
  if (outcome.read || outcome.saved || !outcome.error.empty()) frames_due_ = kSettlingFrames;
}

// All engines answer alike; this machine may lack the one that was used.
Request Viewer::possible_here(Request request) const {
  if (needs_gpu(request.engine) && !has_gpu(state_)) request.engine = EngineChoice::automatic;
  return request;
}

void Viewer::start_session() {
  const Request& asked = waiting_session_->read.session.settings.request;
  session_awaits_gpu_ = needs_gpu(asked.engine) && !state_.gpu;
  if (session_awaits_gpu_) return;  // still being looked for
  const auto found = std::exchange(waiting_session_, nullptr);
  if (!may_open(found->file)) return;
  starting_session_ = found;
  const Settings& settings = found->read.session.settings;
  OpenOptions options = settings.open;
  options.read.max_bytes = state_.settings.open.read.max_bytes;
  if (found->radii_table) options.radii_table = found->radii_table->path;
  session_.open(found->molecule.path, options, canonical(possible_here(settings.request)));
}

// Once its molecule is there, in the place of what a molecule that is opened by itself would get.
void Viewer::show_session() {
  const auto found = std::exchange(starting_session_, nullptr);
  const SessionDocument& s = found->read.session;
  OpenOptions open = std::move(state_.settings.open);  // as the molecule was opened
  state_.settings = s.settings;
  state_.settings.open = std::move(open);
  state_.settings.request = sent_compute_ = possible_here(s.settings.request);
  state_.window.theme = s.view.light_theme ? Theme::light : Theme::dark;
  state_.playback.alpha = false;
  state_.memory.number = {};
  state_.window.page = s.view.panels.page;
  state_.window.page_height = static_cast<float>(s.view.panels.page_height);
  const auto& closed = s.view.panels.closed_sections;
  state_.window.closed_sections = {closed.begin(), closed.end()};
  state_.window.alpha_slider = s.view.panels.alpha_slider;
  state_.window.picture = s.view.picture;
  static_cast<RecordChoices&>(state_.memory.record) = s.view.recording;
  state_.molecule.radii = grown_radii(*session_.state().prepared, state_.settings.request);
  if (s.view.camera.any()) scene_.set_camera_when_drawn(s.view.camera);
  state_.session_file = found->file;
  noted_ = preferred();  // of the session, not of the user
  if (!found->complete()) {
    state_.drop_note = "Not the files that the session was saved with:\n" + found->problem();
  }
  std::string notes;
  for (const std::string& note : found->read.notes) notes += (notes.empty() ? "" : "\n") + note;
  if (!notes.empty()) {
    state_.tell("Not all of the session is understood",
                printable(found->file.string()) + "\n\n" + notes +
                    "\n\nAll the rest is as it was saved. A newer version of the program may know "
                    "more.");
  }
}

std::optional<SessionDocument> Viewer::session_document(const std::filesystem::path& file) const {
  const SessionState& s = session_.state();
  if (!s.opened) return std::nullopt;
  SessionDocument document;
  document.written_by = program_text("alphascope");
  document.molecule =
      refer_to(s.opened->molecule->source, s.opened->molecule->sha256, file.parent_path());
  document.settings = settings();
  document.view = window_of_session();
  if (const auto camera = scene_.camera()) document.view.camera = *camera;
  return document;
}

SessionView Viewer::window_of_session() const {
  const WindowSettings& w = state_.window;
  return {.light_theme = w.theme == Theme::light,
          .camera = {},
          .panels = {w.page,
                     w.page_height,
                     {w.closed_sections.begin(), w.closed_sections.end()},
                     w.alpha_slider},
          .picture = w.picture,
          .recording = state_.memory.record};
}

}  // namespace alphascope
