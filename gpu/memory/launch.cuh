// SPDX-License-Identifier: GPL-3.0-or-later
// The only code with CUDA's launch syntax. All other code in kernels and their callers is plain C++
// for a host compiler. So tests run it without a device (tests/gpu/emulated).
#pragma once

#include <cuda_runtime.h>

#include <cstddef>

namespace alphascope::gpu {

struct LaunchShape {
  unsigned blocks, threads;
  cudaStream_t stream;
  std::size_t shared_bytes = 0;  // dynamic
};

// Launches a kernel. The caller must check cudaGetLastError().
template <class... Parameters, class... Arguments>
void launch(void (*kernel)(Parameters...), const LaunchShape& shape,
            const Arguments&... arguments) {
#ifdef __CUDACC__
  kernel<<<shape.blocks, shape.threads, shape.shared_bytes, shape.stream>>>(arguments...);
#else
  emulated::launch(shape.blocks, shape.threads, shape.shared_bytes, shape.stream,
                   [=] { kernel(arguments...); });
#endif
}

// The block's dynamic shared memory, in a kernel.
__device__ inline unsigned char* dynamic_shared_memory() {
#ifdef __CUDACC__
  extern __shared__ __align__(16) unsigned char memory[];
  return memory;
#else
  return emulated::shared_memory();
#endif
}

}  // namespace alphascope::gpu
