// SPDX-License-Identifier: GPL-3.0-or-later
// The dual-edge engine on a CUDA device. This header is plain C++.
#pragma once

#include <memory>

#include "core/engine/gpu_device.hpp"
#include "core/engines/gpu_library.hpp"

namespace alphascope {

// Looks for a device and runs a small kernel on it. The answer is kept. Never throws.
const GpuDevice& gpu_device();

// Returns whether there is pinned memory of GPU results that are no longer used. Fast; callable
// from any thread.
bool is_gpu_memory_unused();
// Frees that memory. Waits for the device, so it must not be called by the thread that draws.
void free_unused_gpu_memory();

// For a usable device only. Throws as Executor::compute() does.
std::unique_ptr<Executor> make_gpu_executor(std::shared_ptr<const BallSet> balls,
                                            const GpuOptions& options);

}  // namespace alphascope
