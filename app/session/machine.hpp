// What the program runs on, in words, for panels and for whatever carries a time.
#pragma once

#include <cstddef>
#include <string>

namespace alphascope {

struct MachineInfo {
  std::string cpu;  // "AMD EPYC 7B13"; "unknown CPU" where the system does not say
  int threads = 1;  // that the program may use
  // The GPU; the texts are empty without one.
  bool gpu_usable = false;
  std::string gpu, driver;     // "NVIDIA H200", "CUDA driver 13.0"
  std::string gpu_capability;  // compute capability, "9.0"
  std::size_t gpu_memory_bytes = 0;
  // Why there is no usable GPU, what to do, and that results are the same; empty with one.
  std::string gpu_why_not;
};

// The first call looks for a GPU and runs a small kernel on it, which may take a second; the answer
// is kept. Thread-safe; never throws.
const MachineInfo& machine_info();

// "AMD EPYC 7B13, 16 threads; NVIDIA H200, CUDA driver 13.0".
std::string machine_text(const MachineInfo& machine);

}  // namespace alphascope
