// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the GPU that engines may use. The folder gpu/ looks for it.
#pragma once

#include <cstddef>
#include <string>

namespace alphascope {

struct GpuDevice {
  bool usable = false;
  std::string name = {};  // "NVIDIA H200"; empty without a device
  // Set when not usable: the reason, the remedy, and that the CPU engine gives the same results. It
  // does not say that the CPU engine runs instead. The code that chooses the engine says so.
  std::string why_not = {};
  std::string driver = {};     // "CUDA driver 13.0"
  int compute_capability = 0;  // 90 for 9.0
  std::size_t memory_bytes = 0;

  // "9.0"; empty without a device.
  std::string capability_text() const {
    if (compute_capability <= 0) return {};
    return std::to_string(compute_capability / 10) + "." + std::to_string(compute_capability % 10);
  }
};

}  // namespace alphascope
