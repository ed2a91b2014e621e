// What all dialogs that write a file remember together.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace alphascope {

struct SaveMemory {
  std::filesystem::path folder;  // of the file that was saved last; empty: none yet
  // What was typed last for this molecule, by the dialog: without the folder.
  std::map<std::string, std::string> names;
  // The file dialog looks for a place to save to, for this field, and what was found.
  std::string browses_for, found_for;
  std::filesystem::path found;
  std::filesystem::path opens_from;  // where the file dialog was before
};

}  // namespace alphascope
