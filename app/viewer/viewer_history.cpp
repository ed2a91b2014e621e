// Undo and redo: the panels' controls as settings, and back.
#include "app/viewer/molecule_info.hpp"
#include "app/viewer/viewer.hpp"

namespace alphascope {

// The molecule's options as they were sent: what the controls hold may be refused.
Settings Viewer::settings() const {
  return {session_.open_options(), state_.compute, state_.display, state_.picked.items,
          state_.picked.cavities,  state_.clip,    state_.views,   state_.appearance,
          state_.annotations};
}

// Once a frame, when what was typed has been checked.
void Viewer::note_changes() {
  const bool by_itself = state_.memory.playing || state_.memory.playing_models || lessons_.busy() ||
                         sweep_recorder_.busy();
  if (by_itself) {
    editor_.amend(settings());
  } else {
    editor_.set(settings(), gesture_);
  }
  state_.undo_text = editor_.undo_text();
  state_.redo_text = editor_.redo_text();
}

void Viewer::show_settings() {
  const Settings& s = editor_.now();
  state_.open = s.open;
  state_.compute = s.request;
  state_.display = s.display;
  state_.clip = s.clip;
  state_.views = s.views;
  state_.appearance = s.appearance;
  state_.annotations = s.annotations;
  state_.picked.items = s.selection;
  state_.picked.cavities = s.cavities;
  state_.memory.playing = state_.memory.playing_models = false;
  state_.memory.number = {};  // what was being typed is not what is undone
  state_.expression_error.reset();
}

void Viewer::undo() {
  const std::string what = editor_.undo_text();
  if (!editor_.undo()) return;
  show_settings();
  state_.notice = "Undone: " + what;
}

void Viewer::redo() {
  const std::string what = editor_.redo_text();
  if (!editor_.redo()) return;
  show_settings();
  state_.notice = "Redone: " + what;
}

}  // namespace alphascope
