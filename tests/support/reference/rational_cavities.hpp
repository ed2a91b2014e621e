// Cavities straight from their definitions, in rational arithmetic, for a handful of balls. Shares
// nothing with the program but the triangulation's definition in rational_oracle.hpp.
#pragma once

#include <set>
#include <vector>

#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope::testing {

// Is ball m strictly inside the smallest orthosphere of a triangle (1), outside it (-1), or on it
// (0)?
int inside_smallest_orthosphere(const BallSet& balls, std::span<const BallIndex, 3> triangle,
                                BallIndex m);
// The same with weights decreased by explicit numbers, of larger centres by much more. Never 0.
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
  long long betti[3] = {0, 0, 0};  // of K_alpha, by ranks of matrices modulo 2
};

// strict_ties: what ties does not flow. castp_rule: else Pocket's.
RationalCavities rational_cavities(const BallSet& balls, const RationalOracle& oracle,
                                   double alpha_on_lattice, bool strict_ties, bool castp_rule);

}  // namespace alphascope::testing
