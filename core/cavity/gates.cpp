// SPDX-License-Identifier: GPL-3.0-or-later
// Finds when a triangle enters K_alpha, and orders triangles by it exactly.
#include "core/cavity/gates.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "core/cavity/cavity_ground.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/triangulation/incidence.hpp"

namespace alphascope {
namespace {

bool is_filled_before(const CavityGround& ground, std::uint32_t a, std::uint32_t b) {
  const float of_a = ground.flow.alpha_values[a], of_b = ground.flow.alpha_values[b];
  if (of_a != of_b) return of_a < of_b;
  const auto& tetrahedra = ground.triangulation->tetrahedra;
  return compare_ortho_radii(*ground.balls, tetrahedra[a], tetrahedra[b]) < 0;
}

std::span<const BallIndex> decisive_simplex(const CavityGround& ground, const Gate& gate) {
  if (gate.tetrahedron == Cavities::kNone) return ground.incidence.triangles[gate.triangle];
  return ground.triangulation->tetrahedra[gate.tetrahedron];
}

std::array<LatticePoint, 3> sorted_centres(const CavityGround& ground, const Gate& gate) {
  std::array<LatticePoint, 3> centres;
  for (std::size_t k = 0; k < 3; ++k) {
    centres[k] = ground.balls->centres[ground.incidence.triangles[gate.triangle][k]];
  }
  std::sort(centres.begin(), centres.end());
  return centres;
}

}  // namespace

Gate gate_of(const CavityGround& ground, std::uint32_t triangle) {
  std::uint32_t least = Cavities::kNone;
  bool attached = false;
  for (const std::uint32_t t : ground.incidence.tetrahedra_of_triangle[triangle]) {
    if (t == Incidence::kOutside) continue;
    const auto& triangles = ground.incidence.triangles_of_tetrahedron[t];
    const auto k = static_cast<std::size_t>(
        std::find(triangles.begin(), triangles.end(), triangle) - triangles.begin());
    attached = attached || ground.flow.through(t, k);
    if (least == Cavities::kNone || is_filled_before(ground, t, least)) least = t;
  }
  if (attached) return {ground.flow.alpha_values[least], triangle, least};
  return {ortho_radius_rounded(*ground.balls, ground.incidence.triangles[triangle]), triangle,
          Cavities::kNone};
}

bool opens_before(const CavityGround& ground, const Gate& a, const Gate& b) {
  if (a.closes != b.closes) return a.closes > b.closes;
  if (a.triangle == b.triangle) return false;
  const int side = compare_ortho_radii_of(*ground.balls, decisive_simplex(ground, a),
                                          decisive_simplex(ground, b));
  if (side != 0) return side > 0;
  const auto of_a = sorted_centres(ground, a), of_b = sorted_centres(ground, b);
  return of_a != of_b ? of_a < of_b : a.triangle < b.triangle;
}

}  // namespace alphascope
