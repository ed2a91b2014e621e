// SPDX-License-Identifier: GPL-3.0-or-later
// Computes an orthocentre by Cramer's rule.
#include "core/clearance/orthocentre.hpp"

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

RealPoint orthocentre(const BallSet& balls, const std::array<BallIndex, 4>& t) {
  const LiftedInt j = lifted_vector(balls, t[0], t[1]), k = lifted_vector(balls, t[0], t[2]),
                  l = lifted_vector(balls, t[0], t[3]);
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const double twice = 2 * static_cast<double>(determinant(j, k, l));
  const auto at = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    return static_cast<double>(Int128{j.c} * a + Int128{k.c} * b + Int128{l.c} * c) / twice;
  };
  return real_point(balls.centres[t[0]]) +
         RealPoint{at(kl.x, lj.x, jk.x), at(kl.y, lj.y, jk.y), at(kl.z, lj.z, jk.z)};
}

}  // namespace alphascope
