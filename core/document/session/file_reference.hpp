// A file that another one names: by path and by what it holds, so that one that moved is found and
// one that changed is noticed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct FileReference {
  // From the folder of the file that names it; empty where that is not above or beside it.
  std::filesystem::path relative;
  std::filesystem::path absolute;
  std::string sha256;  // 64 hexadecimal digits
  bool empty() const { return relative.empty() && absolute.empty(); }
  friend bool operator==(const FileReference&, const FileReference&) = default;
};

// Of `file`, for what is written into `folder`. Does not look at the disk but for the present
// folder.
FileReference refer_to(const std::filesystem::path& file, const std::string& sha256,
                       const std::filesystem::path& folder);

struct FoundFile {
  enum class State { same, changed, missing };
  State state = State::missing;
  std::filesystem::path path;                    // empty when missing
  std::string sha256;                            // that it has now
  std::vector<std::filesystem::path> looked_at;  // where, in this order
};

// Reads what is there. `folder`: of the file that names it. The first whose content is the same;
// else the first that is there. Throws ReadError when that cannot be read; Cancelled.
FoundFile find_file(const FileReference& wanted, const std::filesystem::path& folder,
                    const RunContext& context = {});

// What is to be told of a file that is not the same: where it was looked for, what differs.
std::string why_not_found(const FileReference& wanted, const FoundFile& found);

}  // namespace alphascope
