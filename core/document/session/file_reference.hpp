// SPDX-License-Identifier: GPL-3.0-or-later
// A reference to a file by path and content. So a moved file is found, and a changed file is
// noticed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct FileReference {
  // Path from the folder of the referring file; empty if the file is not in or below that folder.
  std::filesystem::path relative;
  std::filesystem::path absolute;
  std::string sha256;  // 64 hexadecimal digits
  bool empty() const { return relative.empty() && absolute.empty(); }
  friend bool operator==(const FileReference&, const FileReference&) = default;
};

// A reference to `file`, for a file that is written into `folder`. It asks the disk only for the
// present folder.
FileReference refer_to(const std::filesystem::path& file, const std::string& sha256,
                       const std::filesystem::path& folder);

struct FoundFile {
  enum class State { same, changed, missing };
  State state = State::missing;
  std::filesystem::path path;                    // empty when missing
  std::string sha256;                            // present hash of the file
  std::vector<std::filesystem::path> looked_at;  // paths that were tried, in this order
};

// Reads the files at the known paths. Returns the first with the same content, otherwise the first
// that exists. `folder` is that of the referring file. Throws ReadError if none can be read
// although one exists, and Cancelled.
FoundFile find_file(const FileReference& wanted, const std::filesystem::path& folder,
                    const RunContext& context = {});

// A message on a file that is not the same: the paths that were tried, or the difference.
std::string why_not_found(const FileReference& wanted, const FoundFile& found);

}  // namespace alphascope
