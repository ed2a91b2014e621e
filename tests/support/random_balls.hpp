// Sets of balls that are hard on exactness, for any suite. All are small integers on a lattice of
// unit 1 Å (digits = 0) unless said otherwise, so that alpha in Å² is alpha on the lattice.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope::testing {

using Random = std::mt19937_64;

struct NamedBalls {
  std::string name;
  BallSet balls;

  // Å²: an alpha of some such units is neither nothing nor everything to the set.
  double alpha_unit() const { return name == "random" ? 1e4 : 1; }
};

int random_int(Random& random, int low, int high);  // inclusive

// Centres within [-extent, extent]³, radii within [low_radius, high_radius].
BallSet random_balls(Random& random, int count, int extent, int low_radius, int high_radius);

void add_ball(BallSet& balls, int x, int y, int z, int radius);

// The same balls in another order: new ball n is old ball order[n].
BallSet permuted(const BallSet& balls, const std::vector<BallIndex>& order);

// At most `most` balls each: none to five, equal centres, hidden, collinear, coplanar, cospherical,
// corners of lattices and polytopes, tiny dense sets, and the extremes of the lattice's bounds.
std::vector<NamedBalls> small_hard_sets(Random& random, int most);

// Tens to hundreds of balls: the same kinds at size, cubic, body-centred and FCC lattices with
// equal and with random radii, planes, lines. At most `most` balls each, picked at random.
std::vector<NamedBalls> large_hard_sets(Random& random, int most = 1000);

}  // namespace alphascope::testing
