// SPDX-License-Identifier: GPL-3.0-or-later
// Allocates device memory within the limit of device_memory.hpp, and counts it.
#pragma once

#include <cuda_runtime.h>

#include <cstddef>

namespace alphascope::gpu {

// As cudaMalloc() and cudaFree(). Beyond the limit there is no memory. Any thread may call them.
cudaError_t allocate_device_memory(void** memory, std::size_t bytes);
void free_device_memory(void* memory, std::size_t bytes);

// As cudaMemGetInfo(), within the limit.
cudaError_t device_memory_room(std::size_t* free, std::size_t* all);

}  // namespace alphascope::gpu
