// Opening a molecule from a file of any format that we know, plain or packed with gzip.
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
  // Most text to accept, after unpacking (bytes): a small gzip file can unpack to terabytes.
  std::uint64_t max_bytes = std::uint64_t{4} << 30;
  const FileFormat* format = nullptr;  // null: told by content and name
  // Read to its end instead of opening the path, which then only names the molecule: for standard
  // input. Stays open.
  std::optional<int> descriptor = {};
  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

// Throws ReadError with a sentence for people, and Cancelled.
Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options = {},
                       const RunContext& context = {});

// A text that is loaded already, by the format's own reader. Null, and a text of blanks: the error
// says what the text looks like.
Molecule read_format(const FileFormat* format, const ReaderInput& input);

}  // namespace alphascope
