// SPDX-License-Identifier: GPL-3.0-or-later
// Options of reading a molecule from a file.
#pragma once

#include <cstdint>
#include <optional>

namespace alphascope {

struct FileFormat;

struct ReadOptions {
  // Limit of the unpacked text in bytes. A small gzip file can unpack to terabytes.
  std::uint64_t max_bytes = std::uint64_t{4} << 30;
  const FileFormat* format = nullptr;  // null: recognised by content and name
  // A descriptor that is read to its end instead of the path, for standard input. The path then
  // only names the molecule. The descriptor stays open.
  std::optional<int> descriptor = {};
  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

}  // namespace alphascope
