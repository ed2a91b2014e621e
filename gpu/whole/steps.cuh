// SPDX-License-Identifier: GPL-3.0-or-later
// The hash sums of a filtration's steps (core/triangulation/hash_steps.hpp).
#pragma once

#include "core/complex/simplex_hash.hpp"
#include "core/triangulation/hash_steps.hpp"
#include "gpu/whole/whole.cuh"

namespace alphascope::gpu {

__global__ void gather_sample(const float* values, std::uint32_t count, std::uint32_t stride,
                              float* sample) {
  const std::uint32_t n = grid_thread();
  if (n * std::uint64_t{stride} < count) sample[n] = values[n * std::uint64_t{stride}];
}

inline constexpr int kStepThreads = 256;
// `sums`: zero before. Each block takes as many simplices as it finds.
template <int N>
__global__ void sum_steps(const std::uint32_t* simplices, const float* values, std::uint32_t count,
                          const StepValues* steps, unsigned long long* sums) {
  __shared__ unsigned long long own[StepValues::kMost + 1];
  __shared__ StepValues limits;
  const int thread = static_cast<int>(threadIdx.x);
  if (thread <= StepValues::kMost) {
    own[thread] = 0;
    limits.value[thread] = steps->value[thread];
  }
  __syncthreads();
  for (std::uint64_t n = grid_thread(); n < count; n += std::uint64_t{gridDim.x} * blockDim.x)
    atomicAdd(&own[limits.step_of(values[n])],
              static_cast<unsigned long long>(simplex_hash<N>(simplices + N * n)));
  __syncthreads();
  if (thread <= StepValues::kMost && own[thread] != 0) atomicAdd(&sums[thread], own[thread]);
}

}  // namespace alphascope::gpu
