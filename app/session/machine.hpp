// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the machine in words, for panels and for results with times.
#pragma once

#include <string>

#include "core/engine/gpu_device.hpp"

namespace alphascope {

struct MachineInfo {
  std::string cpu;  // such as "AMD EPYC 7B13"; "unknown CPU" if the system does not say
  int threads = 1;  // usable by the program
  GpuDevice gpu;
};

// The first call looks for a GPU and runs a small kernel on it, which may take a second. Later
// calls return the same object. Thread-safe; never throws.
const MachineInfo& machine_info();

// For example "AMD EPYC 7B13, 16 threads; NVIDIA H200, CUDA driver 13.0".
std::string machine_text(const MachineInfo& machine);

}  // namespace alphascope
