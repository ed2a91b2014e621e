// How much memory the program has and may still have.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace alphascope {

struct SystemFiles {
  std::filesystem::path memory = "/proc/meminfo", groups = "/proc/self/cgroup";
  std::filesystem::path group_root = "/sys/fs/cgroup";
};

std::uint64_t resident_bytes();   // of this process; 0 where /proc is missing
std::uint64_t allocated_bytes();  // of the C library's heap, in use

// Without swapping, and within the limits set for this process (ulimit -v) and its control group
// (containers, systemd; version 2); nothing where none of them can be read.
std::optional<std::uint64_t> available_bytes(const SystemFiles& files = {});

// Of the option --drawing-memory: so many megabytes (10^6 bytes), or what is available.
std::optional<std::uint64_t> available_or(std::optional<std::uint64_t> megabytes);

}  // namespace alphascope
