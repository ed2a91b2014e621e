// SPDX-License-Identifier: GPL-3.0-or-later
// Makes random sets of balls that are hard on exactness.
#include "tests/support/random_balls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope::testing {
namespace {

using AddPoint = std::function<void(int, int, int)>;

BallSet empty_set() {
  BallSet balls;
  balls.lattice.digits = 0;
  return balls;
}

// Adds every permutation of (a, b, c) with every choice of signs. They are points of one sphere.
void add_orbit(BallSet& balls, int a, int b, int c, int radius) {
  int v[3] = {a, b, c};
  std::sort(v, v + 3);
  do {
    for (int signs = 0; signs < 8; ++signs) {
      const int x = signs & 1 ? -v[0] : v[0], y = signs & 2 ? -v[1] : v[1],
                z = signs & 4 ? -v[2] : v[2];
      // -0 equals 0, so the repetition is skipped.
      if ((signs & 1 && v[0] == 0) || (signs & 2 && v[1] == 0) || (signs & 4 && v[2] == 0))
        continue;
      add_ball(balls, x, y, z, radius);
    }
  } while (std::next_permutation(v, v + 3));
}

BallSet lattice_balls(int n, int step, int kind, const std::function<int()>& radius) {
  BallSet balls = empty_set();
  for (int x = 0; x < 2 * n; ++x) {
    for (int y = 0; y < 2 * n; ++y) {
      for (int z = 0; z < 2 * n; ++z) {
        const bool cubic = x % 2 == 0 && y % 2 == 0 && z % 2 == 0;
        const bool body = (x % 2 == y % 2) && (y % 2 == z % 2);
        const bool face = (x + y + z) % 2 == 0;
        if (kind == 0 ? cubic : kind == 1 ? body : face) {
          add_ball(balls, x * step, y * step, z * step, radius());
        }
      }
    }
  }
  return balls;
}

void truncate(BallSet& balls, Random& random, int most) {
  std::vector<BallIndex> order(balls.size());
  for (BallIndex i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  if (static_cast<int>(order.size()) > most) order.resize(static_cast<std::size_t>(most));
  balls = permuted(balls, order);
}

BallSet on_flat(Random& random, int count, int dimension, int extent, int high_radius) {
  // Integer combinations of one or two random directions through a random point.
  int u[3], v[3], o[3];
  for (int a = 0; a < 3; ++a) {
    u[a] = random_int(random, -2, 2);
    v[a] = dimension == 2 ? random_int(random, -2, 2) : 0;
    o[a] = random_int(random, -5, 5);
  }
  if (u[0] == 0 && u[1] == 0 && u[2] == 0) u[0] = 1;
  BallSet balls = empty_set();
  for (int n = 0; n < count; ++n) {
    const int s = random_int(random, -extent, extent), t = random_int(random, -extent, extent);
    add_ball(balls, o[0] + s * u[0] + t * v[0], o[1] + s * u[1] + t * v[1],
             o[2] + s * u[2] + t * v[2], random_int(random, 1, high_radius));
  }
  return balls;
}

BallSet equal_centres(Random& random, int count, int extent) {
  BallSet balls = random_balls(random, count, extent, 1, 4);
  for (std::size_t i = 1; i < balls.size(); i += 2) {
    balls.centres[i] = balls.centres[static_cast<std::size_t>(random_int(random, 0, int(i) - 1))];
    if (i % 4 == 1) balls.radii[i] = balls.radii[i - 1];
  }
  return balls;
}

BallSet around_a_large_one(Random& random, int count) {
  BallSet balls = random_balls(random, count, 8, 1, 6);
  balls.radii[0] = 12;
  balls.centres[0] = {1, -1, 0};
  return balls;
}

BallSet extremes(Random& random, int count) {
  BallSet balls = empty_set();
  const int c = kMaxLatticeCoordinate, r = kMaxLatticeRadius;
  for (int n = 0; n < count; ++n) {
    const auto coordinate = [&] {
      return random_int(random, 0, 1)
                 ? random_int(random, -c, c)
                 : (random_int(random, 0, 1) ? c : -c) / random_int(random, 1, 3);
    };
    const int x = coordinate(), y = coordinate(), z = coordinate();
    add_ball(balls, x, y, z, random_int(random, 0, 1) ? r : random_int(random, 1, r));
  }
  return balls;
}

using Direction = std::array<double, 3>;
using Point3 = std::array<double, 3>;

// A vector of whole numbers whose length is whole, with any signs and order.
struct WholeDirection {
  std::array<int, 3> vector;
  int length;

  Direction unit() const {
    const double l = length;
    return {vector[0] / l, vector[1] / l, vector[2] / l};
  }
};
WholeDirection whole_direction(Random& random) {
  static constexpr WholeDirection kAll[] = {
      {{1, 0, 0}, 1}, {{3, 4, 0}, 5}, {{2, 3, 6}, 7}, {{1, 2, 2}, 3}, {{4, 4, 7}, 9}};
  WholeDirection d = kAll[random_int(random, 0, 4)];
  for (int& x : d.vector) x *= 2 * random_int(random, 0, 1) - 1;
  std::shuffle(d.vector.begin(), d.vector.end(), random);
  return d;
}

// A direction of length 1. Every other one has whole components and a whole length, so that
// distances can be whole.
Direction random_direction(Random& random) {
  if (random_int(random, 0, 1) != 0) return whole_direction(random).unit();
  Direction d;
  double length = 0;
  do {
    length = 0;
    for (double& x : d) {
      x = random_int(random, -1000000, 1000000);
      length += x * x;
    }
  } while (length == 0);
  for (double& x : d) x /= std::sqrt(length);
  return d;
}

int on_the_lattice(double coordinate) {
  const double bound = kMaxLatticeCoordinate;
  return static_cast<int>(std::round(std::clamp(coordinate, -bound, bound)));
}

void add_ball_beside(BallSet& balls, const LatticePoint& p, const Direction& d, double distance,
                     int radius) {
  add_ball(balls, on_the_lattice(p.x + distance * d[0]), on_the_lattice(p.y + distance * d[1]),
           on_the_lattice(p.z + distance * d[2]), radius);
}

// Every order of magnitude is equally likely.
int random_radius(Random& random, int high) {
  const double share = random_int(random, 0, 1 << 20) / static_cast<double>(1 << 20);
  return std::clamp(static_cast<int>(std::exp(share * std::log(high))), 1, high);
}

// Any place, a corner of the lattice, or the middle.
LatticePoint random_place(Random& random) {
  const int kind = random_int(random, 0, 2), c = kMaxLatticeCoordinate;
  const auto coordinate = [&] {
    return kind == 0 ? random_int(random, -c, c) : kind == 1 ? (random() & 1 ? c : -c) : 0;
  };
  const int x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

// The point of the first ball's sphere in that direction, or a mirrored one if that is off the
// lattice.
Point3 on_the_rim(const LatticePoint& middle, int radius, Direction d) {
  Point3 point{double(middle.x), double(middle.y), double(middle.z)};
  for (int a = 0; a < 3; ++a) {
    if (std::abs(point[a] + radius * d[a]) > kMaxLatticeCoordinate) d[a] = -d[a];
    point[a] += radius * d[a];
  }
  return point;
}

// A random point of the circle in which the spheres of the first and last ball meet. If they do not
// meet, the point of the first sphere nearest to the last ball.
Point3 grazing_point(Random& random, const BallSet& balls) {
  const LatticePoint &c = balls.centres.front(), &p = balls.centres.back();
  const double large = balls.radii.front(), radius = balls.radii.back();
  Direction out{double(p.x) - c.x, double(p.y) - c.y, double(p.z) - c.z};
  const double distance = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
  if (distance == 0) return on_the_rim(c, balls.radii.front(), random_direction(random));
  for (double& x : out) x /= distance;
  Direction across = random_direction(random);
  const double outward = across[0] * out[0] + across[1] * out[1] + across[2] * out[2];
  double length = 0;
  for (int a = 0; a < 3; ++a) {
    across[a] -= outward * out[a];
    length += across[a] * across[a];
  }
  // Distances from the first centre, along `out` and across it.
  const double along =
      std::min(large, (distance * distance + large * large - radius * radius) / (2 * distance));
  const double side = std::sqrt((large - along) * (large + along) / std::max(length, 1e-6));
  Point3 point{double(c.x), double(c.y), double(c.z)};
  for (int a = 0; a < 3; ++a) point[a] += along * out[a] + side * across[a];
  return point;
}

}  // namespace

BallSet grazing_balls(Random& random, int count, int digits, int largest) {
  BallSet balls;
  balls.lattice.digits = digits;
  if (count == 0) return balls;
  const LatticePoint first = random_place(random);
  add_ball(balls, first.x, first.y, first.z, largest);
  while (static_cast<int>(balls.size()) < count) {
    const auto last = static_cast<int>(balls.size()) - 1;
    const auto to = static_cast<std::size_t>(random_int(random, 0, last));
    const int radius = random_radius(random, largest);
    add_ball_beside(balls, balls.centres[to], random_direction(random),
                    double(balls.radii[to]) + radius + random_int(random, -1, 1), radius);
  }
  return balls;
}

BallSet balls_at_a_rim(Random& random, int count, int digits, int large) {
  BallSet balls;
  balls.lattice.digits = digits;
  if (count == 0) return balls;
  const LatticePoint middle = random_place(random);
  add_ball(balls, middle.x, middle.y, middle.z, large);
  // For larger radii the margins of a single-precision test exceed its rounding errors.
  const int most = random_radius(random, std::max(1, large / 256));
  Point3 contact = on_the_rim(middle, large, random_direction(random));
  while (static_cast<int>(balls.size()) < count) {
    const WholeDirection along = whole_direction(random);
    const int radius = std::max(1, most - random_radius(random, most) / 2);
    int other = std::max(1, most - random_radius(random, most) / 2);
    // Centres are whole. Their distance is whole when the sum of radii is a multiple of the length.
    other += (along.length - (radius + other) % along.length) % along.length;
    other = std::min(other, kMaxLatticeRadius);
    const Direction d = along.unit();
    add_ball(balls, on_the_lattice(contact[0] - radius * d[0]),
             on_the_lattice(contact[1] - radius * d[1]), on_the_lattice(contact[2] - radius * d[2]),
             radius);
    const int miss = random_int(random, 0, 1) * random_int(random, -1, 1);
    add_ball_beside(balls, balls.centres.back(), d, double(radius) + other + miss, other);
    contact = random_int(random, 0, 1) != 0 ? grazing_point(random, balls)
                                            : on_the_rim(middle, large, random_direction(random));
  }
  balls.centres.resize(static_cast<std::size_t>(count));
  balls.radii.resize(static_cast<std::size_t>(count));
  return balls;
}

std::vector<NamedBalls> sets_at_the_bounds(Random& random, int most) {
  std::vector<NamedBalls> sets;
  for (int digits = kMinLatticeDigits; digits <= 6; ++digits) {
    const auto add = [&](const std::string& name, BallSet balls) {
      const double radius = balls.radii.empty() ? 1 : balls.radii[0];
      const double unit = balls.lattice.square_angstrom(radius * radius / 8);
      sets.push_back({name + ", " + std::to_string(digits) + " digits", std::move(balls), unit});
    };
    const int large = digits == 6 ? kMaxLatticeRadius : random_int(random, 1 << 22, 1 << 26) - 1;
    add("grazing", grazing_balls(random, most, digits, large));
    add("grazing, small", grazing_balls(random, most, digits, 1 << random_int(random, 1, 20)));
    add("at a rim", balls_at_a_rim(random, most, digits, large));
  }
  return sets;
}

int random_int(Random& random, int low, int high) {
  return static_cast<int>(
      low + static_cast<std::int64_t>(random() % (std::uint64_t(high - std::int64_t{low}) + 1)));
}

void add_ball(BallSet& balls, int x, int y, int z, int radius) {
  balls.centres.push_back({x, y, z});
  balls.radii.push_back(radius);
}

BallSet random_balls(Random& random, int count, int extent, int low_radius, int high_radius) {
  BallSet balls = empty_set();
  for (int n = 0; n < count; ++n) {
    const int x = random_int(random, -extent, extent), y = random_int(random, -extent, extent),
              z = random_int(random, -extent, extent);
    add_ball(balls, x, y, z, random_int(random, low_radius, high_radius));
  }
  return balls;
}

std::vector<BallIndex> unpermuted(const std::vector<BallIndex>& list,
                                  const std::vector<BallIndex>& order) {
  std::vector<BallIndex> result;
  for (const BallIndex ball : list) result.push_back(order[ball]);
  std::sort(result.begin(), result.end());
  return result;
}

BallSet permuted(const BallSet& balls, const std::vector<BallIndex>& order) {
  BallSet result;
  result.lattice = balls.lattice;
  for (const BallIndex i : order) {
    result.centres.push_back(balls.centres[i]);
    result.radii.push_back(balls.radii[i]);
  }
  return result;
}

std::vector<NamedBalls> small_hard_sets(Random& random, int most) {
  std::vector<NamedBalls> sets;
  const auto add = [&](const std::string& name, BallSet balls) {
    truncate(balls, random, most);
    sets.push_back({name, std::move(balls), 1});
  };
  for (int n = 0; n <= 5; ++n) {
    add(std::to_string(n) + " balls", random_balls(random, n, 6, 1, 4));
    add(std::to_string(n) + " balls, dense", random_balls(random, n, 1, 1, 3));
  }
  add("random", random_balls(random, most, 40, 3, 20));
  add("random, coarse", random_balls(random, most, 3, 1, 3));
  add("random, dense", random_balls(random, most, 1, 1, 2));
  add("equal centres", equal_centres(random, most, 4));
  add("equal centres, dense", equal_centres(random, most, 1));
  add("one large ball hides others", around_a_large_one(random, most));
  add("collinear", on_flat(random, most, 1, 5, 3));
  add("collinear, equal radii", on_flat(random, most, 1, 5, 1));
  add("coplanar", on_flat(random, most, 2, 3, 4));
  add("coplanar, equal radii", on_flat(random, most, 2, 2, 1));
  for (const auto& [name, kind] : {std::pair("cubic", 0), {"body-centred", 1}, {"FCC", 2}}) {
    add(std::string(name) + " corner", lattice_balls(1 + (kind == 0), 1, kind, [] { return 1; }));
    add(std::string(name) + " corner, mixed radii",
        lattice_balls(2, 2, kind, [&] { return random_int(random, 1, 3); }));
  }
  const int orbits[][3] = {{1, 1, 1}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 2, 1}, {1, 2, 2}};
  for (const auto& o : orbits) {
    BallSet balls = empty_set();
    add_orbit(balls, o[0], o[1], o[2], 2);
    if (random_int(random, 0, 1)) add_ball(balls, 0, 0, 0, random_int(random, 1, 3));
    add("cospherical " + std::to_string(o[0]) + std::to_string(o[1]) + std::to_string(o[2]), balls);
  }
  BallSet tetrahedron = empty_set();
  for (const auto& v : {std::array{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) {
    add_ball(tetrahedron, 3 * v[0], 3 * v[1], 3 * v[2], 2);
  }
  add("regular tetrahedron", tetrahedron);
  add("extremes of the lattice", extremes(random, most));
  for (NamedBalls& set : sets_at_the_bounds(random, most)) sets.push_back(std::move(set));
  return sets;
}

std::vector<NamedBalls> large_hard_sets(Random& random, int most) {
  std::vector<NamedBalls> sets;
  const auto add = [&](const std::string& name, BallSet balls) {
    sets.push_back({name, std::move(balls), name == "random" ? 1e4 : 1});
  };
  const auto one = [] { return 1; };
  const auto mixed = [&] { return random_int(random, 1, 4); };
  for (const auto& [name, kind] : {std::pair("cubic", 0), {"body-centred", 1}, {"FCC", 2}}) {
    add(std::string(name) + " lattice", lattice_balls(3, 1, kind, one));
    add(std::string(name) + " lattice, mixed radii", lattice_balls(3, 2, kind, mixed));
  }
  add("random", random_balls(random, 300, 1000, 100, 300));
  add("random, coarse", random_balls(random, 300, 6, 1, 4));
  add("random, dense", random_balls(random, 200, 3, 1, 3));
  add("equal centres", equal_centres(random, 300, 6));
  add("hidden", random_balls(random, 300, 12, 1, 14));
  add("collinear", on_flat(random, 60, 1, 40, 5));
  add("coplanar", on_flat(random, 150, 2, 6, 4));
  add("coplanar, equal radii", on_flat(random, 150, 2, 6, 2));
  BallSet shells = empty_set();
  for (const auto& o : {std::array{5, 0, 0}, {4, 3, 0}, {7, 1, 0}, {5, 4, 3}, {6, 5, 8}}) {
    add_orbit(shells, o[0], o[1], o[2], 3);
  }
  add("cospherical shells", shells);
  add("extremes of the lattice", extremes(random, 120));
  // These sets are few, because beyond the filters' range integers decide everything.
  for (NamedBalls& set : sets_at_the_bounds(random, 30)) sets.push_back(std::move(set));
  for (NamedBalls& set : sets) truncate(set.balls, random, most);  // also shuffles
  return sets;
}

}  // namespace alphascope::testing
