// Undo and redo: settings, and the view where the program has moved it for a change.
#include "app/viewer/parts/history.hpp"

#include <utility>

namespace alphascope {

// The molecule's options as they were sent: those that the panels hold may be refused.
Settings History::settings() const {
  Settings settings = state_.settings;
  settings.open = session_.open_options();
  return settings;
}

// Once a frame, when what was typed has been checked.
void History::note_changes(bool by_itself) {
  const std::size_t entries = editor_.depth();
  if (std::exchange(state_.selection_followed, false)) {
    Settings followed = editor_.now();
    followed.selection = state_.settings.selection;
    editor_.follow(followed);
  }
  if (by_itself) {
    editor_.amend(settings());
  } else {
    editor_.set(settings(), gesture_);
  }
  const bool new_entry = editor_.depth() > entries;
  if (new_entry) {
    moved_views_.erase(moved_views_.lower_bound(editor_.depth()), moved_views_.end());
    entry_gesture_ = gesture_;
  }
  const bool of_entry = new_entry || (gesture_ != 0 && gesture_ == entry_gesture_);
  if (by_itself || !of_entry) view_before_calls_.reset();
  note_view();
  state_.undo_text = editor_.undo_text();
  state_.redo_text = editor_.redo_text();
}

void History::show_settings() {
  state_.settings = editor_.now();
  state_.playback.alpha = state_.playback.models = false;
  state_.memory.number = {};  // what was being typed is not what is undone
  state_.expression_error.reset();
}

// With the change, in the requests of this frame, or later, when other atoms are there. Those that
// belong to one entry are one movement.
void History::note_view() {
  std::optional<CameraPlace> before = std::exchange(view_before_calls_, std::nullopt);
  if (const auto left = scene_.take_left_view(); left && !before) before = left;
  if (!before || editor_.depth() == 0) return;
  MovedView& moved =
      moved_views_.try_emplace(editor_.depth(), MovedView{*before, {}, 0}).first->second;
  moved.moves = view_moves_;
}

// Where the atoms change, with their picture.
void History::bring_view_back(const CameraPlace& view, bool other_atoms) {
  if (other_atoms) {
    scene_.set_camera_when_drawn(view);
  } else {
    scene_.move_camera(view);
  }
}

// A view that somebody has moved since is theirs.
void History::undo() {
  const std::string what = editor_.undo_text();
  const auto moved = moved_views_.find(editor_.depth());
  const OpenOptions open = editor_.now().open;
  if (!editor_.undo()) return;
  show_settings();
  state_.notice = "Undone: " + what;
  if (moved == moved_views_.end() || moved->second.moves != view_moves_) return;
  moved->second.after = scene_.camera();
  bring_view_back(moved->second.before, editor_.now().open != open);
}

void History::redo() {
  const std::string what = editor_.redo_text();
  const OpenOptions open = editor_.now().open;
  if (!editor_.redo()) return;
  show_settings();
  state_.notice = "Redone: " + what;
  const auto moved = moved_views_.find(editor_.depth());
  if (moved == moved_views_.end() || moved->second.moves != view_moves_) return;
  if (moved->second.after) bring_view_back(*moved->second.after, editor_.now().open != open);
}

void History::restart() {
  editor_.restart(settings());
}

void History::restart(const Settings& settings) {
  editor_.restart(settings);
  show_settings();
}

void History::amend() {
  editor_.amend(settings());
}

void History::put(const Editor& editor) {
  editor_ = editor;
  show_settings();
}

// The undo steps of what was open before a lesson.
void History::take_back() {
  const auto history = std::exchange(to_come_back_, std::nullopt);
  if (!history) return;
  editor_ = *history;
  editor_.amend(settings());
}

void History::move_view(const std::function<void()>& how) {
  const std::optional<CameraPlace> before = scene_.camera();
  how();
  if (scene_.camera() == before) return;
  ++view_moves_;
  if (!view_before_calls_) view_before_calls_ = before;
}

}  // namespace alphascope
