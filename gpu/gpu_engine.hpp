// The dual-edge engine on a CUDA device. Plain C++: the program builds and runs without CUDA, and
// then learns here why there is no device.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/engine/engine.hpp"
#include "core/engine/gpu_device.hpp"

namespace alphascope {

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
