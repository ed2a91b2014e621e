// SPDX-License-Identifier: GPL-3.0-or-later
// Makes five balls of each kind.
#include "tests/support/five_balls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope::testing {
namespace {

int on_the_lattice(double value, int bound = kMaxLatticeCoordinate) {
  return static_cast<int>(std::clamp<double>(std::round(value), -bound, bound));
}

// The last two balls are within a unit of the plane of the first three.
BallSet nearly_coplanar(Random& random, int extent, int radius) {
  BallSet balls = random_balls(random, 5, extent, 1, radius);
  auto& c = balls.centres;
  for (int n = 3; n < 5; ++n) {
    const int s = random_int(random, -2, 2), t = random_int(random, -2, 2);
    const auto at = [&](int a, int b, int o) {
      return on_the_lattice(o + double(s) * (a - o) + double(t) * (b - o) +
                            random_int(random, -1, 1));
    };
    c[n] = {at(c[1].x, c[2].x, c[0].x), at(c[1].y, c[2].y, c[0].y), at(c[1].z, c[2].z, c[0].z)};
  }
  return balls;
}

// All balls are within about a unit of one sphere.
BallSet nearly_cospherical(Random& random, double size, int low_radius, int radius) {
  BallSet balls = random_balls(random, 5, 100000, low_radius, radius);
  for (LatticePoint& p : balls.centres) {
    const double length = std::sqrt(double(p.x) * p.x + double(p.y) * p.y + double(p.z) * p.z);
    const double scale = length > 0 ? size / length : 0;
    p = {on_the_lattice(p.x * scale), on_the_lattice(p.y * scale), on_the_lattice(p.z * scale)};
  }
  return balls;
}

// Small whole numbers with many ties, times `scale` and shifted by at most `shake`.
BallSet nearly_tied(Random& random, int scale, int shake) {
  BallSet balls = random_balls(random, 5, 2, 1, 3);
  const auto moved = [&](int value) {
    return on_the_lattice(double(value) * scale + random_int(random, -shake, shake));
  };
  for (LatticePoint& p : balls.centres) p = {moved(p.x), moved(p.y), moved(p.z)};
  for (int& r : balls.radii) r = std::clamp(std::abs(moved(r)), 1, kMaxLatticeRadius);
  return balls;
}

// Differences from the first ball are `bound` give or take a few units, or any size up to it.
BallSet around_a_bound(Random& random, int bound, int radius) {
  const auto value = [&](int most) {
    const int size = random_int(random, 0, 2) != 0 ? most - random_int(random, -2, 4)
                                                   : random_int(random, 0, most);
    return size;
  };
  const auto coordinate = [&] {
    return on_the_lattice((random_int(random, 0, 1) != 0 ? 1.0 : -1.0) * value(bound));
  };
  BallSet balls;
  for (int n = 0; n < 5; ++n) {
    const int x = n == 0 ? 0 : coordinate(), y = n == 0 ? 0 : coordinate(),
              z = n == 0 ? 0 : coordinate();
    add_ball(balls, x, y, z, std::clamp(value(radius), 1, kMaxLatticeRadius));
  }
  return balls;
}

struct Kind {
  const char* name;
  std::function<BallSet(Random&)> make;
};

BallSet equal_radii(BallSet balls, int radius) {
  std::fill(balls.radii.begin(), balls.radii.end(), radius);
  return balls;
}

const Kind kKinds[kFiveBallKinds] = {
    {"single units", [](Random& r) { return random_balls(r, 5, 2, 1, 3); }},
    {"a molecule's", [](Random& r) { return random_balls(r, 5, 7000, 1, 2000); }},
    {"a finer lattice's", [](Random& r) { return random_balls(r, 5, 70000, 1, 20000); }},
    {"random below 2^25", [](Random& r) { return random_balls(r, 5, 1 << 25, 1, 1 << 25); }},
    {"the whole lattice",
     [](Random& r) { return random_balls(r, 5, kMaxLatticeCoordinate, 1, kMaxLatticeRadius); }},
    {"nearly coplanar", [](Random& r) { return nearly_coplanar(r, 5000, 2000); }},
    {"nearly cospherical, radius 1", [](Random& r) { return nearly_cospherical(r, 3000, 1, 1); }},
    {"nearly coplanar, large", [](Random& r) { return nearly_coplanar(r, 1 << 22, 1 << 22); }},
    {"nearly cospherical, large",
     [](Random& r) {
       const int radius = random_int(r, 1, kMaxLatticeRadius);
       return nearly_cospherical(r, 1 << random_int(r, 12, 28), radius, radius);
     }},
    {"nearly tied",
     [](Random& r) { return nearly_tied(r, 1 << random_int(r, 0, 27), random_int(r, 0, 1)); }},
    {"bounds of double", [](Random& r) { return around_a_bound(r, 1 << 25, kMaxLatticeRadius); }},
    {"bounds of float", [](Random& r) { return around_a_bound(r, 1 << 24, 1 << 23); }},
    {"bounds of 128 bits",
     [](Random& r) {
       return around_a_bound(r, r() & 1 ? 1 << 20 : 1 << 17, r() & 1 ? kMaxLatticeRadius : 1 << 17);
     }},
    {"large and equal, near each other",
     [](Random& r) {
       return equal_radii(random_balls(r, 5, 1 << random_int(r, 1, 24), 1, 1),
                          kMaxLatticeRadius - random_int(r, 0, 1 << 25));
     }},
    {"grazing", [](Random& r) { return grazing_balls(r, 5, 6, 1 << random_int(r, 4, 25)); }},
    {"at a rim", [](Random& r) { return balls_at_a_rim(r, 5, 6, kMaxLatticeRadius); }},
};

}  // namespace

const char* kind_of_five(int kind) {
  return kKinds[kind].name;
}

BallSet five_balls(Random& random, int kind) {
  for (;;) {
    BallSet balls = kKinds[kind].make(random);
    std::vector<LatticePoint> sorted = balls.centres;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return balls;
  }
}

}  // namespace alphascope::testing
