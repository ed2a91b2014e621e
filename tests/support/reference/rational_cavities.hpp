// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities straight from their definitions, in rational arithmetic, for a handful of balls. It
// shares no code with the program. From rational_oracle.hpp it takes only the definition of the
// triangulation.
#pragma once

#include <set>
#include <vector>

#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope::testing {

// 1 when ball m is strictly inside the smallest orthosphere of a triangle, -1 when outside, 0 when
// on it.
int inside_smallest_orthosphere(const BallSet& balls, std::span<const BallIndex, 3> triangle,
                                BallIndex m);
// The same with perturbed weights, decreased by small numbers. Larger centres have much larger
// ones. Never 0.
int inside_perturbed_orthosphere(const BallSet& balls, std::span<const BallIndex, 3> triangle,
                                 BallIndex m);

using Simplex = std::vector<BallIndex>;

struct RationalCavity {
  std::set<Simplex> tetrahedra;
  std::set<std::set<Simplex>> mouths;
  std::set<Simplex> sinks;
  Simplex deepest_sink;
  friend auto operator<=>(const RationalCavity&, const RationalCavity&) = default;
};

struct RationalCavities {
  std::set<RationalCavity> cavities;
  std::size_t flow_ties = 0;
  long long betti[3] = {0, 0, 0};  // Betti numbers of K_alpha, by ranks of matrices modulo 2
};

// strict_ties: tied simplices do not flow. castp_rule: CASTp's rule, else Pocket's.
RationalCavities rational_cavities(const BallSet& balls, const RationalOracle& oracle,
                                   double alpha_on_lattice, bool strict_ties, bool castp_rule);

}  // namespace alphascope::testing
