// An engine against the definition in rationals, for suites and for the program that does so for
// hours.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope::testing {

// What was compared.
struct OracleCounts {
  std::size_t complexes = 0, simplices = 0;
};

// Alphas (Å²) at which something happens: the critical values themselves where they are doubles on
// alpha's own lattice, and the nearest alphas on both sides, which round to the same float once the
// value is above 16. And some that have nothing to do with the balls. Ascending.
std::vector<double> interesting_alphas(const RationalOracle& oracle, const Lattice& lattice);

// At most `most` of the alphas, always with the first and last ones, in random order: an engine may
// answer from what it has kept.
std::vector<double> some_of(Random& random, std::vector<double> alphas, std::size_t most);

// The balls as lines "x y z radius", lattice units.
std::string list_balls(const BallSet& balls);

// What differs between two complexes; empty if nothing does.
std::string difference(const AlphaComplex& found, const AlphaComplex& expected);

// The first difference between an engine's complexes, whole and of tetrahedra alone, and the
// oracle's, with the alpha and the balls; empty if there is none. Also looks for what the verifier
// finds.
std::string difference_from_oracle(Engine& engine, const NamedBalls& set,
                                   const RationalOracle& oracle, std::span<const double> alphas,
                                   OracleCounts& counts);

}  // namespace alphascope::testing
