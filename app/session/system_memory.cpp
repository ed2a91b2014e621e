// SPDX-License-Identifier: GPL-3.0-or-later
// Reads memory and its limits from /proc, control groups and the C library.
#include "app/session/system_memory.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

namespace alphascope {
namespace {

using Bytes = std::optional<std::uint64_t>;

// Reads lines "key value", with or without a colon after the key.
Bytes value_of(const std::filesystem::path& file, const std::string& wanted) {
  std::ifstream lines(file);
  std::string key;
  std::uint64_t value = 0;
  while (lines >> key) {
    if (key == wanted && lines >> value) return value;
    lines.clear();
    lines.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

Bytes number_in(const std::filesystem::path& file) {
  std::uint64_t value = 0;
  return std::ifstream(file) >> value ? Bytes(value) : std::nullopt;  // "max" gives no value
}

Bytes lesser(Bytes a, Bytes b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

std::uint64_t pages(bool resident) {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t total = 0, in_memory = 0;
  statm >> total >> in_memory;
  return (resident ? in_memory : total) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// Returns what `ulimit -v` leaves. It limits addresses, not memory, and OpenGL and each thread
// reserve many that they never use. An EGL context with two threads of llvmpipe took 590 MB of
// addresses and 64 MB of memory. A thread's heap and stack take 72 MB of addresses, and the window
// has six threads of its own.
Bytes left_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const std::uint64_t threads = std::clamp(std::thread::hardware_concurrency(), 1u, 32u);
  const std::uint64_t taken =
      pages(false) + (std::uint64_t{600} << 20) + ((threads + 6) * 72 << 20);
  return limit.rlim_cur > taken ? limit.rlim_cur - taken : 0;
}

// Returns the least free memory of any control group from this process' group up to the root. The
// cache of files counts as free, since the system gives it back when needed.
Bytes left_of_control_group(const SystemFiles& system) {
  std::ifstream groups(system.groups);
  std::string path;
  while (std::getline(groups, path) && !path.starts_with("0::/")) continue;
  if (!path.starts_with("0::/")) return std::nullopt;
  const auto& root = system.group_root;
  Bytes least;
  for (std::filesystem::path group = root / path.substr(4);; group = group.parent_path()) {
    const Bytes most = number_in(group / "memory.max"), used = number_in(group / "memory.current");
    const std::uint64_t files = value_of(group / "memory.stat", "inactive_file").value_or(0);
    if (most && used) {
      const std::uint64_t kept = *used - std::min(*used, files);
      least = lesser(least, *most - std::min(*most, kept));
    }
    if (group == root || !group.has_relative_path()) return least;
  }
}

}  // namespace

std::uint64_t resident_bytes() {
  return pages(true);
}

std::uint64_t allocated_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

std::optional<std::uint64_t> available_bytes(const SystemFiles& files) {
  Bytes machine = value_of(files.memory, "MemAvailable:");
  if (machine) *machine <<= 10;
  return lesser(machine, lesser(left_of_address_space(), left_of_control_group(files)));
}

std::optional<std::uint64_t> available_or(std::optional<std::uint64_t> megabytes) {
  return megabytes ? std::optional(*megabytes * 1000000) : available_bytes();
}

}  // namespace alphascope
