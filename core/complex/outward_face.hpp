// SPDX-License-Identifier: GPL-3.0-or-later
// The outward orientation of a face of a tetrahedron.
#pragma once

#include <array>
#include <utility>

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

// The face opposite ball `k` of a tetrahedron that is not flat: counterclockwise when seen from
// outside the tetrahedron. Exact.
inline std::array<BallIndex, 3> outward_face(const BallSet& balls,
                                             const std::array<BallIndex, 4>& tetrahedron,
                                             std::size_t k) {
  std::array<BallIndex, 3> face{tetrahedron[k == 0 ? 1 : 0], tetrahedron[k <= 1 ? 2 : 1],
                                tetrahedron[k <= 2 ? 3 : 2]};
  const auto from = [&](BallIndex i) { return lifted_vector(balls, tetrahedron[k], i); };
  if (determinant(from(face[0]), from(face[1]), from(face[2])) < 0) std::swap(face[1], face[2]);
  return face;
}

}  // namespace alphascope
