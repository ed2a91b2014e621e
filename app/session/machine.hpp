// What the program runs on, in words, for panels and for whatever carries a time.
#pragma once

#include <string>

#include "core/engine/gpu_device.hpp"

namespace alphascope {

struct MachineInfo {
  std::string cpu;  // "AMD EPYC 7B13"; "unknown CPU" where the system does not say
  int threads = 1;  // that the program may use
  GpuDevice gpu;
};

// The first call looks for a GPU and runs a small kernel on it, which may take a second; the answer
// is kept. Thread-safe; never throws.
const MachineInfo& machine_info();

// "AMD EPYC 7B13, 16 threads; NVIDIA H200, CUDA driver 13.0".
std::string machine_text(const MachineInfo& machine);

}  // namespace alphascope
