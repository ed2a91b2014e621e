// The exact part of tetrahedra of a regular triangulation that is outside all balls, as of pockets:
// the angles of their faces alone do not tell it where balls poke through a mouth. Each tetrahedron
// is cut into the power cells that it meets, and the ball of each is taken away.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Of each tetrahedron asked for, in that order. To add up cavities: sums_by_group().
struct ClippedTetrahedra {
  std::vector<double> volume_angstrom3;       // of the whole tetrahedron
  std::vector<double> free_volume_angstrom3;  // outside all balls
  std::vector<double> area_angstrom2;         // of the union's surface within
};

// `tetrahedra`: indices into triangulation.tetrahedra, which is of these balls; their radii grow to
// sqrt(r² + alpha). threads = 0: as many as the machine has. The same bits for any number of them.
// Throws Cancelled, and std::invalid_argument for indices that are none.
ClippedTetrahedra clipped_outside(const Triangulation& triangulation, const BallSet& balls,
                                  const LatticeAlpha& alpha_on_lattice,
                                  std::span<const std::uint32_t> tetrahedra, int threads = 0,
                                  const RunContext& context = {});

}  // namespace alphascope
