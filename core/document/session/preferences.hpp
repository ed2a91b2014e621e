// SPDX-License-Identifier: GPL-3.0-or-later
// Preferences of a user for all windows, kept in a file in the configuration folder. Settings of a
// molecule belong to a session instead.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/engine/engine_choice.hpp"

namespace alphascope {

inline constexpr std::size_t kMostRecentFiles = 12;

struct Preferences {
  bool light_theme = false;
  double scale = 0;                // factor on fonts and controls; 0: scale of the display
  int width = 1440, height = 900;  // of the window, pixels at scale 1
  EngineChoice engine = EngineChoice::automatic;
  std::filesystem::path last_folder;          // of the file dialog; empty: none yet
  std::vector<std::filesystem::path> recent;  // molecules and sessions, the latest first; absolute
  bool presenter_size = false;
  std::string page;   // page below the view that the user chose last; empty: none yet
  bool glide = true;  // views that commands move
  friend bool operator==(const Preferences&, const Preferences&) = default;
};

// $XDG_CONFIG_HOME/alphascope, otherwise ~/.config/alphascope; empty if neither is known.
std::filesystem::path preferences_folder();

struct ReadPreferences {
  Preferences preferences;
  std::string problem;  // sentences for the user; empty: none
  // The file exists but is not a file of preferences, or cannot be read. It must stay unchanged.
  bool keep_file = false;
};
// Never throws. A missing file is no problem. An invalid value is skipped and reported.
ReadPreferences read_preferences(const std::filesystem::path& folder);

// Writes the values that differ between `before` and `now`. The rest of the file stays, since
// another window may have changed it. The file appears whole or not at all. Throws WriteError, and
// ReadError if the file has become unreadable.
void save_preferences(const std::filesystem::path& folder, const Preferences& before,
                      const Preferences& now);

// Moves the file to the top of the list.
void note_recent(Preferences& preferences, const std::filesystem::path& file);

}  // namespace alphascope
