// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the file dialog between frames. Plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace alphascope {

struct FolderQuery;  // folder_listing.hpp

enum class BrowserPurpose : std::uint8_t { molecule, radii_table, session, session_molecule, save };

struct BrowserState {
  bool show = false;
  BrowserPurpose purpose = BrowserPurpose::molecule;
  std::filesystem::path folder;  // empty: the program chooses one
  std::filesystem::path base;    // base of relative paths that are typed
  std::string typed;
  bool by_hand = false;  // the user typed `typed`; else it is the path of the chosen entry
  std::string begun;     // first letters of a name; the first entry with them gets chosen
  std::filesystem::path selected;
  bool all_files = false, hidden_ones = false;
  std::string error;        // why the typed path cannot be opened
  std::string jump;         // letters typed in the list, to jump to a name
  double jump_seconds = 0;  // time of the last such letter, by ImGui's clock
  bool scroll = false;      // the list is to be scrolled to the chosen entry
};

// Returns the folder that the file dialog wants listed; nothing while the dialog is closed.
std::optional<FolderQuery> wanted_listing(const BrowserState& browser);

}  // namespace alphascope
