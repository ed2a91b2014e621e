// SPDX-License-Identifier: GPL-3.0-or-later
// Exclusive prefix sums on the device.
#pragma once

#include <cub/device/device_scan.cuh>

#include <cstddef>

#include "gpu/memory/device_buffer.cuh"

namespace alphascope::gpu {

// out[i] = in[0] + ... + in[i - 1]. `scratch` grows as needed. It is in use until the stream has
// finished the sum.
template <class Numbers, class Number>
void prefix_sum(Numbers in, Number* out, std::size_t count, DeviceBuffer<unsigned char>& scratch,
                cudaStream_t stream) {
  std::size_t bytes = 0;
  check(cub::DeviceScan::ExclusiveSum(nullptr, bytes, in, out, static_cast<int>(count), stream),
        "sizing a prefix sum");
  scratch.reserve(bytes);
  check(
      cub::DeviceScan::ExclusiveSum(scratch.get(), bytes, in, out, static_cast<int>(count), stream),
      "a prefix sum");
}

}  // namespace alphascope::gpu
