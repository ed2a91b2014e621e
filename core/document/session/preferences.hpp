// What a user prefers in every window, in a file in the folder of their configuration. Settings of
// a molecule are not here: they are a session's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/engine/engine_choice.hpp"

namespace alphascope {

inline constexpr std::size_t kMostRecentFiles = 12;

struct Preferences {
  bool light_theme = false;
  double scale = 0;                // of fonts and controls; 0: as the display says
  int width = 1440, height = 900;  // of the window, pixels at scale 1
  EngineChoice engine = EngineChoice::automatic;
  std::filesystem::path last_folder;          // of the file dialog; empty: none yet
  std::vector<std::filesystem::path> recent;  // molecules and sessions, the latest first; absolute
  bool presenter_size = false;
  friend bool operator==(const Preferences&, const Preferences&) = default;
};

// $XDG_CONFIG_HOME/alphascope, else ~/.config/alphascope; empty where neither is known.
std::filesystem::path preferences_folder();

struct ReadPreferences {
  Preferences preferences;
  std::string problem;  // sentences for the user; empty: none
  // The file is there and is none of ours, or cannot be read: it must stay as it is.
  bool keep_file = false;
};
// Never throws. No file is no problem. A value that cannot be is left out, and told.
ReadPreferences read_preferences(const std::filesystem::path& folder);

// Writes what differs between `before` and `now` into the file, and leaves the rest of it as it is
// by now: another window may have changed that. The file appears whole or not at all. Throws
// WriteError, and ReadError where the file has become unreadable.
void save_preferences(const std::filesystem::path& folder, const Preferences& before,
                      const Preferences& now);

// The file goes to the top of the list.
void note_recent(Preferences& preferences, const std::filesystem::path& file);

}  // namespace alphascope
