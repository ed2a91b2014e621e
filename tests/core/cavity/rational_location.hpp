// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the tetrahedra that contain a point by trying each in rationals.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "core/cavity_identity/point_location.hpp"

namespace alphascope::testing {

using RationalPoint = std::array<mpq_class, 3>;

// Moves the place by a small number along x, its square along y and its cube along z. For sets with
// such small coordinates this has the effect of the definition's infinitesimals.
inline RationalPoint moved(const LatticePlace& place, const mpq_class& by) {
  const mpq_class times(place.times);
  return {mpq_class(static_cast<long>(place.x)) / times + by,
          mpq_class(static_cast<long>(place.y)) / times + by * by,
          mpq_class(static_cast<long>(place.z)) / times + by * by * by};
}

inline mpq_class six_volumes(const std::array<RationalPoint, 4>& corner) {
  RationalPoint u, v, w;
  for (int k = 0; k < 3; ++k) {
    u[k] = corner[1][k] - corner[0][k];
    v[k] = corner[2][k] - corner[0][k];
    w[k] = corner[3][k] - corner[0][k];
  }
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

inline std::array<RationalPoint, 4> corners_of(const BallSet& balls,
                                               const std::array<BallIndex, 4>& tetrahedron) {
  std::array<RationalPoint, 4> corner;
  for (int k = 0; k < 4; ++k) {
    const LatticePoint& p = balls.centres[tetrahedron[k]];
    corner[k] = {p.x, p.y, p.z};
  }
  return corner;
}

inline std::vector<std::uint32_t> tetrahedra_at(const BallSet& balls,
                                                const Triangulation& triangulation,
                                                const LatticePlace& place) {
  const RationalPoint at = moved(place, mpq_class(1, 1000000));
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
    const auto corner = corners_of(balls, triangulation.tetrahedra[t]);
    const int whole = sgn(six_volumes(corner));
    bool inside = true;
    for (int k = 0; k < 4; ++k) {
      std::array<RationalPoint, 4> part = corner;
      part[k] = at;
      inside = inside && sgn(six_volumes(part)) == whole;
    }
    if (inside) found.push_back(t);
  }
  return found;
}

}  // namespace alphascope::testing
