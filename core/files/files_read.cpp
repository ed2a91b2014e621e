// SPDX-License-Identifier: GPL-3.0-or-later
// The list of files that were read. A file is identified by its inode number, and by the folder and
// name that the system gives it. Numbers are reused after a file is removed, so a number alone
// proves nothing.
#include "core/files/files_read.hpp"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

using Number = std::pair<dev_t, ino_t>;

struct FileRead {
  std::string name;  // as the user wrote it
  fs::path path;     // with links followed
  off_t bytes = 0;
  timespec changed{};
  unsigned kinds = 0;  // a bit for each FileKind
};

struct FilesRead {
  std::mutex mutex;
  std::vector<FileRead> files;
  std::multimap<Number, std::size_t> by_number;
  std::map<fs::path, std::size_t> by_path;
};

// Never destroyed, since threads may read files until the program ends.
FilesRead& all() {
  static auto& files = *new FilesRead;
  return files;
}

unsigned bit(FileKind kind) {
  return 1u << static_cast<unsigned>(kind);
}

Number number_of(const struct stat& status) {
  return {status.st_dev, status.st_ino};
}

bool unchanged(const FileRead& file, const struct stat& now) {
  return file.bytes == now.st_size && file.changed.tv_sec == now.st_mtim.tv_sec &&
         file.changed.tv_nsec == now.st_mtim.tv_nsec;
}

fs::path without_links(const fs::path& path) {
  std::error_code error;
  fs::path found = fs::canonical(path, error);
  return error ? fs::path() : found;
}

void note(const struct stat& status, const fs::path& name, const fs::path& path, FileKind kind) {
  FilesRead& noted = all();
  const std::lock_guard lock(noted.mutex);
  const auto same = noted.by_number.equal_range(number_of(status));
  for (auto at = same.first; at != same.second; ++at) {
    FileRead& file = noted.files[at->second];
    if (file.path != path) continue;
    file.kinds |= bit(kind);
    file.bytes = status.st_size;
    file.changed = status.st_mtim;
    return;
  }
  noted.files.push_back({name.string(), path, status.st_size, status.st_mtim, bit(kind)});
  noted.by_number.emplace(number_of(status), noted.files.size() - 1);
  noted.by_path[path] = noted.files.size() - 1;
}

bool may_replace(FileKind output, const FileRead& file) {
  return output != FileKind::other && file.kinds == bit(output);
}

// Is the file with this number still the one that was read?
bool is_still(const FileRead& file, const struct stat& now) {
  struct stat there {};
  const bool at_its_path =
      ::stat(file.path.c_str(), &there) == 0 && number_of(there) == number_of(now);
  return at_its_path || unchanged(file, now);
}

std::optional<std::string> find(const struct stat& status, const fs::path& path, FileKind kind) {
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  FilesRead& noted = all();
  const std::lock_guard lock(noted.mutex);
  const auto same = noted.by_number.equal_range(number_of(status));
  for (auto at = same.first; at != same.second; ++at) {
    const FileRead& file = noted.files[at->second];
    if (is_still(file, status) && !may_replace(kind, file)) return file.name;
  }
  const auto at = noted.by_path.find(path);  // another file has this name now
  if (at == noted.by_path.end() || may_replace(kind, noted.files[at->second])) return std::nullopt;
  return noted.files[at->second].name;
}

fs::path path_behind(int descriptor) {
  return without_links("/proc/self/fd/" + std::to_string(descriptor));
}

}  // namespace

void note_read(int descriptor, const fs::path& name, FileKind kind) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return;
  note(status, name, path_behind(descriptor), kind);
}

void note_read(const fs::path& file, FileKind kind) {
  struct stat status {};
  if (file.empty() || ::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  note(status, file, without_links(file), kind);
}

std::optional<std::string> input_replaced_by(const fs::path& output, FileKind kind) {
  struct stat status {};
  if (output.empty() || ::stat(output.c_str(), &status) != 0) return std::nullopt;
  return find(status, without_links(output), kind);
}

std::optional<std::string> input_replaced_by(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return std::nullopt;
  return find(status, path_behind(descriptor), FileKind::other);
}

}  // namespace alphascope
