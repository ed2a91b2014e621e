// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the history of settings: notes changes, and carries out undo and redo.
#include "core/document/session/editor.hpp"

#include <utility>

namespace alphascope {

void Editor::set(const Settings& settings, Gesture gesture) {
  if (settings == now_) return;
  const bool continues = gesture != 0 && gesture == gesture_ && !before_.empty();
  if (!continues) before_.push_back(now_);
  if (before_.size() > kMostEntries) before_.pop_front();
  now_ = settings;
  after_.clear();
  gesture_ = gesture;
  if (before_.back() != now_) return;
  before_.pop_back();
  gesture_ = 0;
}

void Editor::set_without_entry(const Settings& settings) {
  if (settings == now_) return;
  now_ = settings;
  gesture_ = 0;
  if (!before_.empty() && before_.back() == now_) before_.pop_back();
}

void Editor::set_consequence(const Settings& settings) {
  now_ = settings;
  if (before_.empty() || before_.back() != now_) return;
  before_.pop_back();
  gesture_ = 0;
}

void Editor::restart(const Settings& settings) {
  *this = Editor(settings);
}

bool Editor::undo() {
  if (before_.empty()) return false;
  after_.push_back(std::exchange(now_, std::move(before_.back())));
  before_.pop_back();
  gesture_ = 0;
  return true;
}

bool Editor::redo() {
  if (after_.empty()) return false;
  before_.push_back(std::exchange(now_, std::move(after_.back())));
  after_.pop_back();
  gesture_ = 0;
  return true;
}

std::string Editor::undo_text() const {
  return before_.empty() ? "" : difference_text(before_.back(), now_);
}

std::string Editor::redo_text() const {
  return after_.empty() ? "" : difference_text(now_, after_.back());
}

}  // namespace alphascope
