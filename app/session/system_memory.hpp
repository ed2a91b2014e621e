// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that the program uses, and memory that it may still allocate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace alphascope {

struct SystemFiles {
  std::filesystem::path memory = "/proc/meminfo", groups = "/proc/self/cgroup";
  std::filesystem::path group_root = "/sys/fs/cgroup";
};

std::uint64_t resident_bytes();   // of this process; 0 without /proc
std::uint64_t allocated_bytes();  // in use in the C library's heap

// Returns the bytes that the program can still allocate without swapping. The limits of the process
// (ulimit -v) and of its control groups count too; containers and systemd set those of version 2.
// Empty if nothing can be read.
std::optional<std::uint64_t> available_bytes(const SystemFiles& files = {});

// Returns `megabytes` (10^6 bytes; the option --drawing-memory) in bytes, or else
// available_bytes().
std::optional<std::uint64_t> available_or(std::optional<std::uint64_t> megabytes);

}  // namespace alphascope
