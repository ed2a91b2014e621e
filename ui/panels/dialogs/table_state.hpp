// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the dialog that saves a table, and the request that it makes. Plain data.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace alphascope {

struct TableToSave;  // table_to_save.hpp

// Numbers of the formats: 0 CSV, 1 JSON, then those of TableToSave::more.
inline constexpr int kCsvFormat = 0, kJsonFormat = 1, kFirstOfMore = 2;

struct SaveTableRequest {
  std::shared_ptr<const TableToSave> table;
  int format = kCsvFormat;
  std::filesystem::path path;
};

// State of the dialog.
struct TableState {
  std::shared_ptr<const TableToSave> table;  // null: the dialog is closed
  std::string path;                          // as the user types it
  int format = kCsvFormat;
};

}  // namespace alphascope
