// A table of a page that is to be written to a file.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/document/definition.hpp"

namespace alphascope {

struct TableToSave {
  std::string what;       // "Cavities": the title of the dialog, "Save: Cavities"
  std::string file_name;  // that is offered, without ending: "4hhb-cavities"
  Definition<std::string> csv;
  std::optional<Definition<std::string>> json;
  // Of what is on screen when it is asked for. Where `of_the_picture`, no other is saved.
  Inputs inputs;
  bool of_the_picture = true;
};

struct SaveTableRequest {
  std::shared_ptr<const TableToSave> table;
  bool as_json = false;
  std::filesystem::path path;
};

// The dialog.
struct TableMemory {
  std::shared_ptr<const TableToSave> table;  // null: it is closed
  std::string path;                          // as it is typed
  int format = 0;                            // 0 CSV, 1 JSON
};

}  // namespace alphascope
