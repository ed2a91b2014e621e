// The graphics processor that engines may use, as it was found. Who looks for it is gpu's business.
#pragma once

#include <cstddef>
#include <string>

namespace alphascope {

struct GpuDevice {
  bool usable = false;
  std::string name = {};  // "NVIDIA H200"; empty without a device
  // When not usable: why, what to do, and that the CPU engine gives the same results. Not that it
  // runs instead, which is for whoever chooses the engine to say.
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
