// SPDX-License-Identifier: GPL-3.0-or-later
// The exact part of tetrahedra of a regular triangulation that is outside all balls, as for
// pockets. The angles of their faces are not enough where balls reach through a mouth. Each
// tetrahedron is cut into the power cells that it meets, and the ball of each cell is subtracted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Results for each requested tetrahedron, in the order of the request. sums_by_group() adds them up
// for cavities.
struct ExactTetrahedra {
  std::vector<double> volume_angstrom3;       // of the whole tetrahedron
  std::vector<double> free_volume_angstrom3;  // outside all balls
  std::vector<double> area_angstrom2;         // of the union's surface inside it
};

// Measures the tetrahedra with these indices in triangulation.tetrahedra. The triangulation is of
// these balls, whose radii grow to sqrt(r² + alpha). threads = 0: all threads of the machine. The
// results have the same bits for any number of threads. Throws Cancelled, and std::invalid_argument
// for an invalid index.
ExactTetrahedra exact_outside(const Triangulation& triangulation, const BallSet& balls,
                              const LatticeAlpha& alpha_on_lattice,
                              std::span<const std::uint32_t> tetrahedra, int threads = 0,
                              const RunContext& context = {});

}  // namespace alphascope
