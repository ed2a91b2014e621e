// The settings in force and their history. Undo is by snapshots: a setting that is new costs
// nothing here. Main thread only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/document/settings/settings.hpp"

namespace alphascope {

// Names what belongs together: everything between a press of a button or key and its release. Such
// changes are one entry. Those of gesture 0 are one entry each.
using Gesture = std::uint64_t;

class Editor {
 public:
  explicit Editor(Settings settings = {}) : now_(std::move(settings)) {}

  const Settings& now() const { return now_; }

  // A change by the user. A gesture that ends where it began leaves no entry.
  void set(const Settings& settings, Gesture gesture);
  // A change that is no entry: by playback, or by the program when it cannot do what was asked for;
  // in that case the entry of the request goes, too.
  void amend(const Settings& settings);
  // What follows from an earlier change when it is computed, such as the atoms that line a chosen
  // cavity: no entry, and no end of the gesture.
  void follow(const Settings& settings);
  // Another file: from here on there is nothing to go back to.
  void restart(const Settings& settings);

  bool undo();  // false: there was nothing to undo
  bool redo();

  // Entries that undo can take back.
  std::size_t depth() const { return before_.size(); }

  // What would change, "alpha"; empty when nothing would.
  std::string undo_text() const;
  std::string redo_text() const;

  static constexpr std::size_t kMostEntries = 500;

 private:
  Settings now_;
  std::deque<Settings> before_;  // as it was before each entry, the oldest first
  std::vector<Settings> after_;  // as it was before each undo, the latest last
  Gesture gesture_ = 0;          // of the last entry
};

}  // namespace alphascope
