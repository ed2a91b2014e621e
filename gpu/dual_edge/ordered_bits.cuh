// Floats as unsigned numbers of the same order, for atomicMin.
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

// What the cofaces of a face in K_alpha say about it.
inline constexpr std::uint32_t kHasCoface = 1, kHasBoundaryCoface = 2;
// Of an edge: it is in K_alpha whatever they say.
inline constexpr std::uint32_t kUnattached = 4;

__device__ inline std::uint32_t coface_flags(bool interior) {
  return interior ? kHasCoface : kHasCoface | kHasBoundaryCoface;
}
// 0 singular, 1 regular, 2 interior, as SimplexClass.
__device__ inline std::uint8_t class_of(std::uint32_t flags) {
  return !(flags & kHasCoface) ? 0 : flags & kHasBoundaryCoface ? 1 : 2;
}

}  // namespace alphascope::gpu
