// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for CUB's prefix sum (see cuda_runtime.h). As on a device, one kernel leaves sums of
// tiles in the scratch memory for the next. They have the type of the summands.
#pragma once

#include <cuda_runtime.h>

namespace cub {

struct DeviceScan {
  template <class In, class Out, class Count>
  static cudaError_t ExclusiveSum(void* scratch, std::size_t& bytes, In in, Out out, Count count,
                                  cudaStream_t stream) {
    using Sum = std::remove_cvref_t<decltype(in[0])>;
    constexpr Count kTile = 8;
    const std::size_t needed = static_cast<std::size_t>(count / kTile + 1) * sizeof(Sum);
    if (scratch == nullptr) {
      bytes = needed;
      return cudaSuccess;
    }
    if (bytes < needed) return cudaErrorInvalidValue;
    Sum* const sums = static_cast<Sum*>(scratch);
    emulated::enqueue(stream, [=] {
      Sum sum = 0;
      for (Count i = 0; i < count; ++i) {
        if (i % kTile == 0) sums[i / kTile] = sum;
        sum += in[i];
      }
    });
    emulated::enqueue(stream, [=] {
      Sum sum = 0;
      for (Count i = 0; i < count; ++i) {
        if (i % kTile == 0) sum = sums[i / kTile];
        const Sum own = in[i];
        out[i] = sum;
        sum += own;
      }
    });
    return cudaSuccess;
  }
};

}  // namespace cub
