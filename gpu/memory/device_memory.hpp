// SPDX-License-Identifier: GPL-3.0-or-later
// The device memory that the engines hold, and a limit for it, which emulates a smaller card or
// leaves room to other programs. device_buffer.cuh allocates.
#pragma once

#include <cstddef>
#include <string>

namespace alphascope::gpu {

// Any thread may call all functions. Counts are in bytes, and begin at 0 for each program.
class DeviceMemory {
 public:
  static std::size_t held();
  static std::size_t most_held();  // since the start, or since the last forget_most()
  static void forget_most();

  // The environment variable ALPHASCOPE_GPU_MEMORY sets the limit, in MB (10^6 bytes). Returns what
  // is wrong with its value; empty: nothing.
  static std::string read_limit();
  static void set_limit(std::size_t bytes);  // 0: no limit
  static std::size_t limit();
};

}  // namespace alphascope::gpu
