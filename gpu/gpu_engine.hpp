// The dual-edge engine on a CUDA device. This header is plain C++. The program also builds and runs
// without CUDA, and these functions then tell why there is no device.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/engine/engine.hpp"
#include "core/engine/gpu_device.hpp"

namespace alphascope {

// Looks for a device and runs a small kernel on it. The answer is kept. Never throws.
const GpuDevice& gpu_device();

// Returns whether there is pinned memory of GPU results that are no longer used. Fast; callable
// from any thread.
bool is_gpu_memory_unused();
// Frees that memory. Waits for the device, so it must not be called by the thread that draws.
void free_unused_gpu_memory();

// Options of the device's engine. Results do not depend on them.
struct GpuOptions {
  // Number of chunks of balls in a run, 1 to 16; 0: the fastest.
  int chunks = 0;
};

// Returns null if the device cannot be used, and sets *why_not to the reason. Single requests that
// do not fit the device are computed by the CPU engine. Their AlphaComplex says so in engine.route.
std::unique_ptr<Engine> make_gpu_engine(std::shared_ptr<const BallSet> balls, EngineOptions options,
                                        std::string* why_not, GpuOptions gpu_options = {});

}  // namespace alphascope
