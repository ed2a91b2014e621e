// The dual-edge engine on a CUDA device. Plain C++: the program builds and runs without CUDA, and
// then learns here why there is no device.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/engine/engine.hpp"

namespace alphascope {

struct GpuDevice {
  bool usable = false;
  std::string name;  // "NVIDIA H200"; empty without a device
  // When not usable: why, what to do, and that the CPU engine gives the same results. Not that it
  // runs instead, which is for whoever chooses the engine to say.
  std::string why_not;
  std::string driver;          // "CUDA driver 13.0"
  int compute_capability = 0;  // 90 for 9.0
  std::size_t memory_bytes = 0;
};

// Looks for a device and runs a small kernel on it; the answer is kept. Never throws.
const GpuDevice& gpu_device();

// Pinned memory of results of GPU engines that nobody will use any more: is there any? Quick, from
// any thread.
bool is_gpu_memory_unused();
// Frees it. Waits for the device: not for the thread that draws.
void free_unused_gpu_memory();

// How the device's engine goes about it. Results do not depend on it.
struct GpuOptions {
  // In how many chunks a run goes through the balls, 1 to 16; 0: as is quickest.
  int chunks = 0;
};

// Null when the device cannot be used: *why_not then says why. The engine falls back to the CPU's
// for single requests that do not fit the device (its AlphaComplex says so in engine.route).
std::unique_ptr<Engine> make_gpu_engine(std::shared_ptr<const BallSet> balls, EngineOptions options,
                                        std::string* why_not, GpuOptions gpu_options = {});

}  // namespace alphascope
