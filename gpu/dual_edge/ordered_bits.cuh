// SPDX-License-Identifier: GPL-3.0-or-later
// Floats as unsigned numbers in the same order, for atomicMin.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

namespace alphascope::gpu {

inline constexpr std::uint32_t kNoValue = ~0u;  // above all numbers

__device__ inline std::uint32_t ordered_bits(float value) {
  const std::uint32_t bits = __float_as_uint(value);
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
__device__ inline float from_ordered_bits(std::uint32_t bits) {
  return __uint_as_float(bits & 0x80000000u ? bits & 0x7fffffffu : ~bits);
}

}  // namespace alphascope::gpu
