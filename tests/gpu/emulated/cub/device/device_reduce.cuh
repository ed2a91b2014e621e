// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for CUB's sum (see cuda_runtime.h). It uses scratch memory as on a device, and adds in
// the type of the result.
#pragma once

#include <cuda_runtime.h>

namespace cub {

struct DeviceReduce {
  template <class In, class Out, class Count>
  static cudaError_t Sum(void* scratch, std::size_t& bytes, In in, Out out, Count count,
                         cudaStream_t stream) {
    using Total = std::remove_cvref_t<decltype(*out)>;
    if (scratch == nullptr) {
      bytes = sizeof(Total);
      return cudaSuccess;
    }
    if (bytes < sizeof(Total)) return cudaErrorInvalidValue;
    Total* const total = static_cast<Total*>(scratch);
    emulated::enqueue(stream, [=] {
      *total = 0;
      for (Count i = 0; i < count; ++i) *total += in[i];
    });
    emulated::enqueue(stream, [=] { *out = *total; });
    return cudaSuccess;
  }
};

}  // namespace cub
