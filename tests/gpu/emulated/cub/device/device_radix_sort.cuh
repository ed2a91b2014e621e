// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for CUB's stable sort of pairs (see cuda_runtime.h).
#pragma once

#include <cuda_runtime.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace cub {

struct DeviceRadixSort {
  template <class Key, class Value>
  static cudaError_t SortPairs(void* scratch, std::size_t& bytes, const Key* keys, Key* keys_out,
                               const Value* values, Value* values_out, int count, int begin_bit,
                               int end_bit, cudaStream_t stream) {
    if (scratch == nullptr) {
      bytes = static_cast<std::size_t>(count) * sizeof(Value) + 1;
      return cudaSuccess;
    }
    if (bytes < static_cast<std::size_t>(count) * sizeof(Value)) return cudaErrorInvalidValue;
    emulated::enqueue(stream, [=] {
      const int bits = end_bit - begin_bit;
      const Key mask = bits >= static_cast<int>(8 * sizeof(Key)) ? ~Key{0} : (Key{1} << bits) - 1;
      std::vector<int> order(static_cast<std::size_t>(count));
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [=](int a, int b) {
        return (keys[a] >> begin_bit & mask) < (keys[b] >> begin_bit & mask);
      });
      for (int n = 0; n < count; ++n) {
        keys_out[n] = keys[order[static_cast<std::size_t>(n)]];
        values_out[n] = values[order[static_cast<std::size_t>(n)]];
      }
    });
    return cudaSuccess;
  }
};

}  // namespace cub
