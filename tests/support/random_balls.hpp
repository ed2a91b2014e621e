// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of balls that are hard on exactness, for any suite. Coordinates are small integers. Without
// digits the lattice unit is 1 Å, so alpha in Å² is alpha on the lattice.
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
  double unit = 1;

  // In Å². An alpha of a few such units gives a complex between the empty one and the whole
  // triangulation.
  double alpha_unit() const { return unit; }
};

int random_int(Random& random, int low, int high);  // inclusive

// Centres within [-extent, extent]³, radii within [low_radius, high_radius].
BallSet random_balls(Random& random, int count, int extent, int low_radius, int high_radius);

void add_ball(BallSet& balls, int x, int y, int z, int radius);

// Each ball touches an earlier one, or misses or overlaps it by about a unit. Radii go down to 1,
// and every order of magnitude is equally likely. The first ball has radius `largest`, and lies in
// a corner of the lattice or anywhere. Centres beyond the lattice are moved to its bounds.
BallSet grazing_balls(Random& random, int count, int digits, int largest);

// A ball of radius `large`, and pairs of small balls that touch in a point of its sphere. Their
// centres are inside and outside of it. Two pairs in three touch exactly, the others miss by a
// unit. For every other pair the point is also on the previous ball's sphere. So differences of
// coordinates are nearly equal, and much larger than the small balls. Whether a pair meets decides
// which simplices exist.
BallSet balls_at_a_rim(Random& random, int count, int digits, int large);

// Sets of both kinds up to the bounds of the lattice, with 3 to 6 digits.
std::vector<NamedBalls> sets_at_the_bounds(Random& random, int most);

// The same balls in another order. New ball n is old ball order[n].
BallSet permuted(const BallSet& balls, const std::vector<BallIndex>& order);
// Translates a list of new balls to the old ones, in ascending order.
std::vector<BallIndex> unpermuted(const std::vector<BallIndex>& list,
                                  const std::vector<BallIndex>& order);

// Sets of at most `most` balls each. Some have up to five balls, some have hidden, collinear,
// coplanar or cospherical balls. Others have equal centres, are corners of lattices and polytopes,
// or are small and dense. The rest are at the lattice's bounds, like sets_at_the_bounds().
std::vector<NamedBalls> small_hard_sets(Random& random, int most);

// The same kinds with tens to hundreds of balls, at most `most` each, picked at random. Also cubic,
// body-centred and FCC lattices with equal and with random radii, planes, lines, and
// sets_at_the_bounds().
std::vector<NamedBalls> large_hard_sets(Random& random, int most = 1000);

}  // namespace alphascope::testing
