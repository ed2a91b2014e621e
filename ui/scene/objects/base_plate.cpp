// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the rings of a base on both sides, and closes the rim between them.
#include "ui/scene/objects/base_plate.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace alphascope {
namespace {

using Corners = std::array<std::uint8_t, 3>;

// Indices in the outline. The bond C4-C5 divides a purine into its two rings.
constexpr std::array<Corners, 4> kOneRing{{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
constexpr std::array<Corners, 7> kTwoRings{
    {{0, 1, 2}, {0, 2, 3}, {0, 3, 7}, {0, 7, 8}, {3, 4, 5}, {3, 5, 6}, {3, 6, 7}}};

std::span<const Corners> faces_of(const BasePlate& plate) {
  if (plate.corners == 9) return kTwoRings;
  return kOneRing;
}

// The normal around which the outline turns left; its atoms need not lie in one plane.
RealPoint normal_of(const BasePlate& plate) {
  RealPoint sum;
  for (std::size_t k = 1; k + 1 < plate.corners; ++k) {
    sum = sum + cross(plate.outline[k] - plate.outline[0], plate.outline[k + 1] - plate.outline[0]);
  }
  return unit_vector(sum);
}

}  // namespace

void add_plate(const BasePlate& plate, SmoothMesh& mesh) {
  const RealPoint normal = normal_of(plate), half = 0.5 * kPlateThickness * normal;
  auto& corners = mesh.corners;
  const auto count = static_cast<std::int32_t>(plate.corners);
  const auto first = static_cast<std::int32_t>(mesh.points());
  for (const int side : {1, -1}) {
    for (std::size_t k = 0; k < plate.corners; ++k) {
      mesh.add_point(plate.outline[k] + side * half, side * normal, plate.colour);
    }
  }
  for (const auto& [a, b, c] : faces_of(plate)) {
    corners.insert(corners.end(), {first + a, first + b, first + c});
    corners.insert(corners.end(), {first + count + a, first + count + c, first + count + b});
  }
  for (std::size_t k = 0; k < plate.corners; ++k) {
    const RealPoint &from = plate.outline[k], &to = plate.outline[(k + 1) % plate.corners];
    const RealPoint outwards = unit_vector(cross(to - from, normal));
    const auto rim = static_cast<std::int32_t>(mesh.points());
    for (const RealPoint& at : {from + half, from - half, to - half, to + half}) {
      mesh.add_point(at, outwards, plate.colour);
    }
    corners.insert(corners.end(), {rim, rim + 1, rim + 2, rim, rim + 2, rim + 3});
  }
}

}  // namespace alphascope
