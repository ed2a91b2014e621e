// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which sets an engine can afford, and sets up suites.
#include "tests/support/engines.hpp"

#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/neighbours/uniform_grid.hpp"

namespace alphascope::testing {

bool EngineFactory::affords(const BallSet& balls, double alpha_angstrom2) const {
  if (most_tuples == std::numeric_limits<double>::infinity()) return true;
  const double alpha = balls.lattice.alpha_on_lattice(alpha_angstrom2).nearest();
  const UniformGrid grid = make_uniform_grid(balls, alpha, coincident_hidden(balls));
  const double later = sample_neighbours(grid, 64).mean / 2;
  return static_cast<double>(grid.size()) * later * later * later / 6 < most_tuples;
}

}  // namespace alphascope::testing
