// SPDX-License-Identifier: GPL-3.0-or-later
// The state that all dialogs which write a file share. Plain data.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace alphascope {

struct SaveState {
  std::filesystem::path folder;  // folder of the file written last; empty: none yet
  // For each dialog the file name typed last for this molecule, without its folder.
  std::map<std::string, std::string> names;
  // The field for which the file dialog looks for a place to save to. Then the field for which
  // `found` was chosen.
  std::string browses_for, found_for;
  std::filesystem::path found;
  std::filesystem::path opens_from;  // folder that the file dialog showed before
};

}  // namespace alphascope
