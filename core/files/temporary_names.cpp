// SPDX-License-Identifier: GPL-3.0-or-later
// Names temporary files by process, and removes those of processes that have ended.
#include "core/files/temporary_names.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStart = ".alphascope-", kEnd = ".tmp";

// ".alphascope-PROCESS-NUMBER.tmp"
std::optional<pid_t> process_of(std::string_view name) {
  if (!name.starts_with(kStart) || !name.ends_with(kEnd)) return std::nullopt;
  const char* const end = name.data() + name.size() - kEnd.size();
  pid_t process = 0;
  const auto first = std::from_chars(name.data() + kStart.size(), end, process);
  if (first.ec != std::errc() || process <= 0 || first.ptr == end || *first.ptr != '-') {
    return std::nullopt;
  }
  int number = 0;
  const auto second = std::from_chars(first.ptr + 1, end, number);
  if (second.ec != std::errc() || second.ptr != end || number < 0) return std::nullopt;
  return process;
}

bool is_there(pid_t process) {
  return ::kill(process, 0) == 0 || errno != ESRCH;
}

// Does the file belong to this user, without a mark of use?
bool is_free(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  struct stat status {};
  const bool free = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                    status.st_uid == ::geteuid() && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return free;
}

}  // namespace

fs::path temporary_name(const fs::path& target, int attempt) {
  return target.parent_path() / (std::string(kStart) + std::to_string(::getpid()) + "-" +
                                 std::to_string(attempt) + std::string(kEnd));
}

void mark_as_in_use(int descriptor) {
  static_cast<void>(::flock(descriptor, LOCK_EX | LOCK_NB));
}

void remove_left_behind(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> seen;
  const std::lock_guard lock(mutex);
  if (!seen.insert(folder).second) return;
  std::error_code error;
  const fs::path named = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator at(named, error), end; !error && at != end; at.increment(error)) {
    const auto process = process_of(at->path().filename().native());
    if (!process || is_there(*process) || !is_free(at->path())) continue;
    ::unlink(at->path().c_str());
  }
}

}  // namespace alphascope
