// SPDX-License-Identifier: GPL-3.0-or-later
// A point of the decimal lattice, and the bounds of the lattice. lattice.hpp has its unit.
#pragma once

#include <compare>
#include <cstdint>

namespace alphascope {

// Bounds that keep every exact predicate within its integer width (exact_rho.hpp). Coordinate
// differences fit 31 bits, weights are exact as doubles, and power differences fit 64 bits.
inline constexpr std::int32_t kMaxLatticeCoordinate = (1 << 29) - 1;
inline constexpr std::int32_t kMaxLatticeRadius = (1 << 26) - 1;

struct LatticePoint {
  std::int32_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

// The square of the distance. Exact, because differences fit 31 bits.
inline std::int64_t square_distance(const LatticePoint& a, const LatticePoint& b) {
  const std::int64_t x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

}  // namespace alphascope
