// Sets of balls that are hard on exactness, for any suite. All are small integers on a lattice of
// unit 1 Å (digits = 0) where no digits are said, so that alpha in Å² is alpha on the lattice.
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

  // Å²: an alpha of some such units is neither nothing nor everything to the set.
  double alpha_unit() const { return unit; }
};

int random_int(Random& random, int low, int high);  // inclusive

// Centres within [-extent, extent]³, radii within [low_radius, high_radius].
BallSet random_balls(Random& random, int count, int extent, int low_radius, int high_radius);

void add_ball(BallSet& balls, int x, int y, int z, int radius);

// Each ball touches an earlier one, but for a unit or so in both directions. Radii, down to 1, are
// as likely of any order of magnitude; the first, in a corner of the lattice or anywhere, is
// `largest`. Centres beyond the lattice are brought back to its bounds.
BallSet grazing_balls(Random& random, int count, int digits, int largest);

// A ball of radius `large`, and pairs of small ones that touch each other in a point of its sphere,
// two in three exactly, the others but for a unit; their centres are in it and outside. Every other
// pair's point is on the sphere of the ball before, too. So differences of coordinates are nearly
// equal and much larger than the small balls, and whether a pair meets decides about simplices.
BallSet balls_at_a_rim(Random& random, int count, int digits, int large);

// The two above up to the bounds of the lattice, on lattices of 3 to 6 digits.
std::vector<NamedBalls> sets_at_the_bounds(Random& random, int most);

// The same balls in another order: new ball n is old ball order[n].
BallSet permuted(const BallSet& balls, const std::vector<BallIndex>& order);
// What a list of balls of that set is among the first ones; ascending.
std::vector<BallIndex> unpermuted(const std::vector<BallIndex>& list,
                                  const std::vector<BallIndex>& order);

// At most `most` balls each: none to five, equal centres, hidden, collinear, coplanar, cospherical,
// corners of lattices and polytopes, tiny dense sets, the extremes of the lattice's bounds, and
// sets_at_the_bounds().
std::vector<NamedBalls> small_hard_sets(Random& random, int most);

// Tens to hundreds of balls: the same kinds at size, cubic, body-centred and FCC lattices with
// equal and with random radii, planes, lines, and sets_at_the_bounds(). At most `most` balls each,
// picked at random.
std::vector<NamedBalls> large_hard_sets(Random& random, int most = 1000);

}  // namespace alphascope::testing
