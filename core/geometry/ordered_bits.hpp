// SPDX-License-Identifier: GPL-3.0-or-later
// Floats as unsigned numbers in the same order, for minima and maxima by atomic operations. Host
// and device.
#pragma once

#include <cstdint>

#include "core/geometry/host_device.hpp"

namespace alphascope {

inline constexpr std::uint32_t kNoValue = ~0u;  // above all numbers

ALPHASCOPE_HOST_DEVICE inline std::uint32_t ordered_bits(float value) {
  const auto bits = __builtin_bit_cast(std::uint32_t, value);
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
ALPHASCOPE_HOST_DEVICE inline float from_ordered_bits(std::uint32_t bits) {
  return __builtin_bit_cast(float, bits & 0x80000000u ? bits & 0x7fffffffu : ~bits);
}

}  // namespace alphascope
