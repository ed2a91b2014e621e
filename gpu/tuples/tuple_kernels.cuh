// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels from the bodies of core/tuples/tuple_body.hpp, and their reading of balls through
// textures. Streams, memory and timing are in tuple_executor.cuh.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

#include "core/tuples/tuple_input.hpp"

namespace alphascope::gpu {

// Works on the device only; returns 0 where nvcc compiles for the host.
template <class T>
ALPHASCOPE_INLINE T texel(cudaTextureObject_t texture, std::uint32_t at) {
#if defined(__CUDACC__) && !defined(__CUDA_ARCH__)
  static_cast<void>(texture);
  static_cast<void>(at);
  return {};
#else
  return tex1Dfetch<T>(texture, static_cast<int>(at));
#endif
}

// Reads balls through texture objects over linear memory.
struct TextureReader {
  cudaTextureObject_t records, reaches;

  ALPHASCOPE_INLINE BallRecord ball(std::uint32_t slot) const {
    const int4 t = texel<int4>(records, slot);
    return {t.x, t.y, t.z, t.w};
  }
  ALPHASCOPE_INLINE float reach(std::uint32_t slot) const { return texel<float>(reaches, slot); }
};

// A power of two. The 200 or so registers of kernel III then fit any device.
constexpr int kTupleThreads = 128;

template <class Body>
__global__ void __launch_bounds__(kTupleThreads) run_for_each(Body body, std::uint64_t count) {
  const std::uint64_t step = std::uint64_t{gridDim.x} * blockDim.x;
  for (std::uint64_t n = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x; n < count;
       n += step) {
    body(n);
  }
}

// For a count that is known on the device only.
template <class Body>
__global__ void __launch_bounds__(kTupleThreads)
    run_for_each_of(Body body, const std::uint64_t* count) {
  const std::uint64_t step = std::uint64_t{gridDim.x} * blockDim.x, end = *count;
  for (std::uint64_t n = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x; n < end; n += step) {
    body(n);
  }
}

// The values for a scan over count + 1 items. The last item adds nothing, so that its sum is the
// total.
template <class Value>
struct PaddedValue {
  Value value;
  std::uint64_t count;
  ALPHASCOPE_HOST_DEVICE std::uint64_t operator()(std::uint64_t n) const {
    return n < count ? value(n) : 0;
  }
};

}  // namespace alphascope::gpu
