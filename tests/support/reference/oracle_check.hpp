// SPDX-License-Identifier: GPL-3.0-or-later
// Compares an engine with the definition in rationals, for suites and for a program that runs for
// hours.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope::testing {

// Numbers of compared complexes and simplices.
struct OracleCounts {
  std::size_t complexes = 0, simplices = 0;
};

// Alphas (Å²) at which the complex changes, in ascending order. They are the critical values, where
// these are doubles on alpha's lattice, and the nearest alphas on both sides. Above 16 Å² all three
// round to the same float. Some alphas that have nothing to do with the balls are added.
std::vector<double> interesting_alphas(const RationalOracle& oracle, const Lattice& lattice);

// At most `most` of the alphas, with the first and last ones. They are in random order, as an
// engine may answer from earlier results.
std::vector<double> some_of(Random& random, std::vector<double> alphas, std::size_t most);

// The balls as lines "x y z radius", lattice units.
std::string list_balls(const BallSet& balls);

// The difference between two complexes in words; empty if there is none.
std::string difference(const AlphaComplex& found, const AlphaComplex& expected);

// The first difference between an engine's complexes and the oracle's, with the alpha and the
// balls. Whole complexes and tetrahedra alone are compared. Empty if there is none. The verifier
// checks the complexes as well.
std::string difference_from_oracle(Engine& engine, const NamedBalls& set,
                                   const RationalOracle& oracle, std::span<const double> alphas,
                                   OracleCounts& counts);

}  // namespace alphascope::testing
