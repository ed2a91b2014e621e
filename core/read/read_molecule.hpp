// Opens a molecule from a file of any known format, plain or packed with gzip.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/files/read_error.hpp"
#include "core/molecule/molecule.hpp"
#include "core/read/file_format.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct ReadOptions {
  // Limit of the unpacked text in bytes. A small gzip file can unpack to terabytes.
  std::uint64_t max_bytes = std::uint64_t{4} << 30;
  const FileFormat* format = nullptr;  // null: recognised by content and name
  // A descriptor that is read to its end instead of the path, for standard input. The path then
  // only names the molecule. The descriptor stays open.
  std::optional<int> descriptor = {};
  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

// Throws ReadError with a sentence for people, and Cancelled.
Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options = {},
                       const RunContext& context = {});

// Reads a loaded text with the format's own reader. For a null format or a blank text, the error
// says what the text looks like.
Molecule read_format(const FileFormat* format, const ReaderInput& input);

}  // namespace alphascope
