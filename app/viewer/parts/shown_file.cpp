// SPDX-License-Identifier: GPL-3.0-or-later
// Settings, colours, title and dialogs at the opening of a file.
#include "app/viewer/parts/shown_file.hpp"

#include <utility>

#include "app/viewer/molecule_info.hpp"
#include "app/viewer/session_text.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {

ShownFile::ShownFile(const Parts& parts, std::function<bool()> benchmark_busy)
    : p_(parts),
      opening_(parts.host, parts.state, parts.scene, parts.session, parts.history,
               parts.preferences, parts.due, std::move(benchmark_busy)) {}

bool ShownFile::take_molecule(float line_scale) {
  const SessionState& s = p_.session.state();
  ViewState& state = p_.state;
  const bool another = p_.scene.molecule() != s.molecule;
  state.molecule = describe_molecule(*s.opened);
  state.molecule.radii = grown_radii(*s.prepared, state.settings.request);
  if (another) {
    colour_by_what_differs(state.molecule.contents);
    if (file_ != s.opened->deposited) take_file();
    // Colours and looks that the molecule decides, before its first picture.
    p_.sender.send_look(line_scale);
  }
  // After a new selection in the same molecule, the last result stays on screen until the next is
  // ready.
  p_.scene.set_molecule(s.opened);
  return another;
}

void ShownFile::take_file() {
  const SessionState& s = p_.session.state();
  ViewState& state = p_.state;
  file_ = s.opened->deposited;
  state.drop_note = opening_.take_drop_note();
  p_.host.set_title(state.molecule.name + " – Alphascope");
  close_dialogs("another file was opened");
  state.close_errors(kNotOpened);
  state.close_errors(kNotChanged);
  p_.sender.moves().forget();
  reset_settings();
  state.settings.objects =
      first_objects_ ? *first_objects_ : usual_objects(state.molecule.contents);
  const auto session = opening_.starting();
  const std::filesystem::path& source = file_->source;
  const bool of_session = session && session->molecule.path == source;
  if (!of_session || session->is_recent) {
    p_.preferences.note_recent_file(of_session && !session->file.empty() ? session->file : source);
  }
  if (of_session) opening_.show_session();
  start_preset();
  open_picture_dialog();
  p_.history.restart();
  if (of_session) p_.history.restore();
}

void ShownFile::close() {
  ViewState& state = p_.state;
  opening_.forget_waiting_session();
  opening_.take_drop_note();
  close_dialogs("its molecule was closed");
  p_.scene.close();
  p_.session.close();
  p_.sender.moves().forget();
  file_ = nullptr;
  state.molecule = {};
  state.drop_note.clear();
  state.engine_note.clear();
  state.compute_error.clear();
  state.viewport.texture = 0;
  state.ours = state.cgal = state.cgal_parallel = {};
  state.playback.alpha = false;
  const std::uint64_t seen = state.channels.balls_key;  // no two sets of balls may share a key
  state.channels = {};
  state.channels.balls_key = seen;
  forget_cavities(state.cavities);
  reset_settings();
  p_.history.restart();
  p_.host.set_title("Alphascope");
}

// Keeps the settings that do not belong to one file.
void ShownFile::reset_settings() {
  ViewState& state = p_.state;
  state.cavities.wanted_row.reset();
  state.playback.models = false;
  state.steps.playing = false;
  Settings fresh;
  fresh.request = state.settings.request;
  fresh.display = state.settings.display;
  state.settings.all = fresh;
  p_.sender.take_options();
  state.expression_error.reset();
  state.expression.typed = state.expression.shown = state.settings.open.balls.selection;
  state.session_file.clear();
}

// Closes dialogs about the previous file.
void ShownFile::close_dialogs(const char* why) {
  ViewState& s = p_.state;
  s.saving.names.clear();
  const bool any = s.dialogs.show_save || s.dialogs.show_export || s.dialogs.show_save_session ||
                   s.record.show || s.save_table.table || !s.dialogs.confirm_assembly.empty();
  if (!any) return;
  s.dialogs.show_save = s.dialogs.show_export = s.dialogs.show_save_session = s.record.show = false;
  s.save_table.table = nullptr;
  s.dialogs.save_path.clear();
  s.dialogs.export_path.clear();
  s.record.path.clear();
  if (s.browser.purpose == BrowserPurpose::save) s.browser.show = false;
  s.dialogs.confirm_assembly.clear();
  s.notice = std::string("The dialog was closed because ") + why + ".";
}

// Colours by element if there is only one chain, else by chain. Colours that the user has chosen
// stay.
void ShownFile::colour_by_what_differs(const MoleculeContents& contents) {
  DisplaySettings& d = p_.state.settings.display;
  const Paint automatic{automatic_colour_, {}, {}, {}};
  if (d.ball_paint != automatic || d.complex_paint != automatic) return;
  automatic_colour_ = contents.chains.size() <= 1 ? ColourBy::element : ColourBy::chain;
  d.ball_paint = d.complex_paint = {automatic_colour_, {}, {}, {}};
}

// Opens the dialog that saves a picture, if the start page opened the molecule for it.
void ShownFile::open_picture_dialog() {
  const auto wanted = std::exchange(p_.state.start.picture_of, std::nullopt);
  if (wanted && (wanted->empty() || *wanted == file_->source)) p_.state.dialogs.show_save = true;
}

// Starts editing the preset of the sandbox that was opened for it.
void ShownFile::start_preset() {
  SandboxState& m = p_.state.sandbox;
  m.pixels_per_angstrom = 0;
  const std::filesystem::path wanted = std::exchange(m.edit_when_open, {});
  if (wanted.empty() || wanted != file_->source) return;
  auto& sandbox = p_.state.settings.open.sandbox;
  if (!sandbox) sandbox = sandbox_of(*p_.session.state().prepared->balls);
}

}  // namespace alphascope
