// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a simplex by their place in it, as templates for host and device need them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry/ball_set.hpp"
#include "core/predicates/lifted.hpp"

namespace alphascope {

// The balls of a simplex on the host. On a device DeviceCorners (gpu/whole/whole.cuh) takes its
// place.
template <std::size_t N>
struct SimplexCorners {
  const BallSet& balls;
  const std::array<BallIndex, N>& simplex;

  // The lifted vector of ball `to` of the simplex, seen from ball `from`.
  LiftedInt lifted(unsigned from, unsigned to) const {
    const BallIndex i = simplex[from], k = simplex[to];
    return lifted_vector(balls.centres[i], balls.radii[i], balls.centres[k], balls.radii[k]);
  }
  std::int64_t weight(unsigned of) const { return balls.weight(simplex[of]); }
};

}  // namespace alphascope
