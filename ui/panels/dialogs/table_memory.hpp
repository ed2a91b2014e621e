// A table of a page that is to be written to a file.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/export/file_writer.hpp"
#include "core/document/store/definition.hpp"

namespace alphascope {

// Another format than those of tables: for other programs.
struct FormatToSave {
  std::string ending, name, what;  // ".glb", "GLB: surfaces"; what is in it: a phrase
  // All files that it is, when the first has this name.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> files;
  Definition<FileWriter> writer;
};

struct TableToSave {
  std::string what;       // "Cavities": the title of the dialog, "Save: Cavities"
  std::string file_name;  // that is offered, without ending: "4hhb-cavities"
  Definition<std::string> csv;
  std::optional<Definition<std::string>> json;
  // Of what is on screen when it is asked for. Where `of_the_picture`, no other is saved.
  Inputs inputs;
  bool of_the_picture = true;
  std::vector<FormatToSave> more = {};
};

// Of what can be saved: 0 CSV, 1 JSON, then those of TableToSave::more.
inline constexpr int kCsvFormat = 0, kJsonFormat = 1, kFirstOfMore = 2;

struct SaveTableRequest {
  std::shared_ptr<const TableToSave> table;
  int format = kCsvFormat;
  std::filesystem::path path;
};

// The dialog.
struct TableMemory {
  std::shared_ptr<const TableToSave> table;  // null: it is closed
  std::string path;                          // as it is typed
  int format = kCsvFormat;
};

}  // namespace alphascope
