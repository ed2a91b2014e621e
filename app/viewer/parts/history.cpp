// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo of settings, and of the views that the program moved for a change.
#include "app/viewer/parts/history.hpp"

#include <utility>

#include "core/selection/selection_error.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/widgets/number_typing.hpp"

namespace alphascope {

// Returns the settings, with the molecule's options as the session has them. Options that panels
// hold may still be refused.
Settings History::settings() const {
  Settings settings = state_.settings.all;
  settings.open = session_.open_options();
  return settings;
}

// Makes entries of changes. To be called once a frame, after typed values have been checked.
void History::note_changes(bool by_itself) {
  const std::size_t entries = editor_.depth();
  if (std::exchange(state_.selection_followed, false)) {
    Settings followed = editor_.now();
    followed.selection = state_.settings.selection;
    editor_.set_consequence(followed);
  }
  if (by_itself) {
    editor_.set_without_entry(settings());
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
  state_.viewport.has_earlier_view = views_.has_earlier();
  state_.viewport.has_later_view = views_.has_later();
}

void History::show_settings() {
  state_.settings.all = editor_.now();
  state_.playback.alpha = state_.playback.models = false;
  state_.number = {};  // typed text that is not an entry yet is dropped
  state_.expression_error.reset();
}

// Notes the view before a move that belongs to the last entry. The move may come in the same frame,
// or later with the picture of other atoms. Several moves for one entry count as one.
void History::note_view() {
  std::optional<CameraPlace> before = std::exchange(view_before_calls_, std::nullopt);
  if (const auto left = scene_.cameras().take_left(); left && !before) before = left;
  if (!before || editor_.depth() == 0) return;
  MovedView& moved =
      moved_views_.try_emplace(editor_.depth(), MovedView{*before, {}, 0}).first->second;
  moved.moves = view_moves_;
}

// Restores a view: at once, or together with the picture of other atoms.
void History::bring_view_back(const CameraPlace& view, bool other_atoms) {
  if (other_atoms) {
    scene_.cameras().set_when_drawn(view);
  } else {
    scene_.cameras().glide([&] { scene_.cameras().move(view); });
  }
}

// Undoes the last entry. Its view comes back too, unless the user has moved the view since.
void History::undo() {
  const std::string what = editor_.undo_text();
  const auto moved = moved_views_.find(editor_.depth());
  const OpenOptions open = editor_.now().open;
  if (!editor_.undo()) return;
  show_settings();
  state_.notice = "Undone: " + what;
  if (moved == moved_views_.end() || moved->second.moves != view_moves_) return;
  moved->second.after = scene_.cameras().place();
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
  views_.clear();
  editor_.restart(settings());
}

void History::restart(const Settings& settings) {
  views_.clear();
  editor_.restart(settings);
  show_settings();
}

void History::amend() {
  editor_.set_without_entry(settings());
}

void History::put(const Editor& editor) {
  editor_ = editor;
  show_settings();
}

// Restores the undo history of the molecule that was open before a lesson.
void History::restore() {
  const auto history = std::exchange(to_restore_, std::nullopt);
  if (!history) return;
  editor_ = *history;
  editor_.set_without_entry(settings());
}

void History::move_view(const std::function<void()>& how) {
  const std::optional<CameraPlace> before = scene_.cameras().place();
  scene_.cameras().glide(how);
  if (scene_.cameras().place() == before) return;
  ++view_moves_;
  if (before) views_.note(*before);
  if (!view_before_calls_) view_before_calls_ = before;
}

// All moves of one drag are one step, and so are turns of the wheel in quick succession.
void History::note_view_moved(const std::optional<CameraPlace>& before) {
  ++view_moves_;
  constexpr std::chrono::milliseconds kPause{700};
  const auto now = std::chrono::steady_clock::now();
  const bool goes_on = view_gesture_ == gesture_ && (gesture_ != 0 || now - wheel_at_ < kPause);
  view_gesture_ = gesture_;
  wheel_at_ = now;
  if (before && !goes_on) views_.note(*before);
}

void History::earlier_view() {
  if (const auto now = scene_.cameras().place()) go_to_view(views_.back(*now));
}

void History::later_view() {
  if (const auto now = scene_.cameras().place()) go_to_view(views_.forward(*now));
}

void History::go_to_view(std::optional<CameraPlace> found) {
  if (!found) return;
  scene_.cameras().glide([&] { scene_.cameras().move(*found); });
  ++view_moves_;
  view_gesture_ = 0;
  wheel_at_ = {};
}

}  // namespace alphascope
