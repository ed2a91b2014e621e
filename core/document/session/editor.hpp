// SPDX-License-Identifier: GPL-3.0-or-later
// The present settings and their history. Undo works with snapshots, so a new setting needs no code
// here. Main thread only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/document/settings/settings.hpp"

namespace alphascope {

// Identifies changes that make one entry: those between the press of a button or key and its
// release. Each change of gesture 0 is an entry of its own.
using Gesture = std::uint64_t;

class Editor {
 public:
  explicit Editor(Settings settings = {}) : now_(std::move(settings)) {}

  const Settings& now() const { return now_; }

  // A change by the user. If a gesture ends with the settings with which it began, it leaves no
  // entry.
  void set(const Settings& settings, Gesture gesture);
  // A change without an entry: by playback, or by the program when it takes back a request that it
  // cannot carry out. If the settings are then those before the last entry, that entry is removed.
  void set_without_entry(const Settings& settings);
  // A consequence of an earlier change that takes time to compute, such as the lining atoms of a
  // selected cavity. It makes no entry and does not end the gesture.
  void set_consequence(const Settings& settings);
  // Starts a new history, for another file.
  void restart(const Settings& settings);

  bool undo();  // false: there was nothing to undo
  bool redo();

  // Number of entries that can be undone.
  std::size_t depth() const { return before_.size(); }

  // The settings that undo or redo would change, such as "alpha"; empty if none.
  std::string undo_text() const;
  std::string redo_text() const;

  static constexpr std::size_t kMostEntries = 500;

 private:
  Settings now_;
  std::deque<Settings> before_;  // settings before each entry, the oldest first
  std::vector<Settings> after_;  // settings before each undo, the latest last
  Gesture gesture_ = 0;          // of the last entry
};

}  // namespace alphascope
