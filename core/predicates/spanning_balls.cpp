// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the spanning balls by exact cross products and determinants.
#include "core/predicates/spanning_balls.hpp"

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

std::vector<BallIndex> spanning_balls(const BallSet& balls, BallIndex first) {
  std::vector<BallIndex> span{first};
  LiftedInt j{}, k{};
  for (BallIndex m = 0; m < balls.size() && span.size() < 4; ++m) {
    const LiftedInt v = lifted_vector(balls, first, m);
    const auto n = cross(j, v);
    const bool beyond = span.size() == 1   ? v.x != 0 || v.y != 0 || v.z != 0
                        : span.size() == 2 ? n.x != 0 || n.y != 0 || n.z != 0
                                           : determinant(j, k, v) != 0;
    if (!beyond) continue;
    (span.size() == 1 ? j : k) = v;
    span.push_back(m);
  }
  return span;
}

int dimension_of_centres(const BallSet& balls) {
  return balls.size() == 0 ? -1 : static_cast<int>(spanning_balls(balls, 0).size()) - 1;
}

}  // namespace alphascope
