// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a page that is to be saved, as derived results.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"

namespace alphascope {

struct FileWriter;

// A format for other programs, beside those of tables.
struct FormatToSave {
  std::string ending, name, what;  // ".glb", "GLB: surfaces"; the contents as a phrase
  // Returns the paths of all files of this format, if the first has this path.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> files;
  Definition<FileWriter> writer;
};

struct TableToSave {
  std::string what;       // "Cavities": the title of the dialog, "Save: Cavities"
  std::string file_name;  // name to offer, without ending: "4hhb-cavities"
  Definition<std::string> csv;
  std::optional<Definition<std::string>> json;
  // Inputs of the data on screen when the user asked to save. If `of_the_picture`, data of other
  // inputs are not saved.
  Inputs inputs;
  bool of_the_picture = true;
  std::vector<FormatToSave> more = {};
};

}  // namespace alphascope
