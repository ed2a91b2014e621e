// SPDX-License-Identifier: GPL-3.0-or-later
// Makes references to files, finds the files, and describes those not found.
#include "core/document/session/file_reference.hpp"

#include <algorithm>
#include <optional>

#include "core/files/file_hash.hpp"
#include "core/files/read_error.hpp"

namespace alphascope {

namespace fs = std::filesystem;

namespace {

fs::path absolute_path(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return (error ? path : absolute).lexically_normal();
}

std::string start_of(const std::string& sha256) {
  return sha256.substr(0, 12);
}

}  // namespace

FileReference refer_to(const fs::path& file, const std::string& sha256, const fs::path& folder) {
  FileReference reference{{}, absolute_path(file), sha256};
  const fs::path relative = reference.absolute.lexically_relative(absolute_path(folder));
  const bool below = !relative.empty() && *relative.begin() != "..";
  if (below) reference.relative = relative;
  return reference;
}

FoundFile find_file(const FileReference& wanted, const fs::path& folder,
                    const RunContext& context) {
  FoundFile found;
  if (!wanted.relative.empty()) found.looked_at.push_back(absolute_path(folder / wanted.relative));
  const auto& looked_at = found.looked_at;
  if (!wanted.absolute.empty() &&
      std::find(looked_at.begin(), looked_at.end(), wanted.absolute) == looked_at.end()) {
    found.looked_at.push_back(wanted.absolute);
  }
  std::optional<ReadError> unreadable;
  for (const fs::path& path : found.looked_at) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) continue;
    std::string sha256;
    try {
      sha256 = hash_of_file(path, context);
    } catch (const ReadError& error) {
      if (!unreadable) unreadable = error;
      continue;
    }
    const bool same = sha256 == wanted.sha256;
    if (same || found.state == FoundFile::State::missing) {
      found.state = same ? FoundFile::State::same : FoundFile::State::changed;
      found.path = path;
      found.sha256 = std::move(sha256);
    }
    if (same) break;
  }
  if (found.state == FoundFile::State::missing && unreadable) throw *unreadable;
  return found;
}

std::string why_not_found(const FileReference& wanted, const FoundFile& found) {
  if (found.state == FoundFile::State::changed) {
    return found.path.string() +
           " is not the file with which the session was saved: its SHA-256 begins with " +
           start_of(found.sha256) + ", and that of the saved file with " + start_of(wanted.sha256) +
           ". It has changed since, or is another file of that name.";
  }
  std::string text = "There is no file";
  for (const fs::path& path : found.looked_at) {
    text += (&path == &found.looked_at.front() ? " " : ", nor ") + path.string();
  }
  return text + ". It has been moved, renamed or removed; its SHA-256 begins with " +
         start_of(wanted.sha256) + ".";
}

}  // namespace alphascope
