// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the closed forms against 113-bit and rational arithmetic.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "core/measure/ball_tetrahedron.hpp"
#include "core/measure/ball_triple.hpp"
#include "tests/core/measure/measured_sets.hpp"

namespace alphascope {
namespace {

using testing::Random;
using testing::random_int;
using Quad = boost::multiprecision::cpp_bin_float_quad;
using Point = std::array<Quad, 3>;

Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Point operator*(const Quad& s, const Point& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
Quad dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Quad length(const Point& a) {
  return sqrt(dot(a, a));
}
Quad angle(const Point& a, const Point& b) {
  return atan2(length(cross(a, b)), dot(a, b));
}
Point centre(const GrownBall& b) {
  return {Quad(b.x), Quad(b.y), Quad(b.z)};
}

// Half of A_m;jk from the corner by Gauss and Bonnet, a different way than the program's.
struct Corner {
  Quad area, volume;
  bool meets;
};
Corner corner_of(const GrownBall& m, const GrownBall& j, const GrownBall& k) {
  const Point u = centre(j) - centre(m), v = centre(k) - centre(m), n = cross(u, v);
  const Quad radius = m.radius, rr = radius * radius;
  const Quad b = (dot(u, u) + rr - Quad(j.radius) * j.radius) / 2;
  const Quad c = (dot(v, v) + rr - Quad(k.radius) * k.radius) / 2;
  const Point foot = (1 / dot(n, n)) * cross(b * v - c * u, n);
  const Quad square = rr - dot(foot, foot);
  // The angle is undefined where only one point is common to all.
  if (square < rr * 1e-24) return {0, 0, false};
  const Quad chord = sqrt(square);
  const Point p = foot + (chord / length(n)) * n;
  const auto arc = [&](const Point& axis, const Quad& lift, const Point& other) {
    const Point pole = (lift / dot(axis, axis)) * axis;  // the circle's centre
    const Point side = other - (dot(other, axis) / dot(axis, axis)) * axis;
    const Quad reach = dot(foot - pole, side) / length(side);
    const Quad half = atan2(chord, reach);
    const Quad h = lift / length(axis);
    const Quad segment = (rr - h * h) * half - reach * chord;
    return std::array<Quad, 3>{half, h, segment};
  };
  const auto at_j = arc(u, b, v), at_k = arc(v, c, u);
  const Quad pi = boost::math::constants::pi<Quad>();
  const auto bend = [&](const Point& axis) {  // along the sphere at p, towards the axis
    return axis - (dot(axis, p) / rr) * p;
  };
  const Quad turn = angle(bend(u), bend(v));  // pi less the inner angle
  Quad area = pi - at_j[0] * at_j[1] / radius - at_k[0] * at_k[1] / radius - turn;
  area *= rr;
  return {area, (radius * area - (at_j[1] * at_j[2] + at_k[1] * at_k[2]) / 2) / 3, true};
}

void expect_triple(const GrownBall (&ball)[3]) {
  const VectorInt n = cross(lifted_vector(ball[0], ball[1]), lifted_vector(ball[0], ball[2]));
  if (n.x == 0 && n.y == 0 && n.z == 0) return;
  const BallPair pair[3] = {ball_pair(ball[1], ball[2]), ball_pair(ball[0], ball[2]),
                            ball_pair(ball[0], ball[1])};
  const BallTriple triple = ball_triple(ball, pair);
  for (int m = 0; m < 3; ++m) {
    const Corner corner = corner_of(ball[m], ball[(m + 1) % 3], ball[(m + 2) % 3]);
    if (!corner.meets) continue;
    const double r = ball[m].grown_radius;
    double largest = r;
    for (const GrownBall& other : ball) largest = std::max(largest, other.grown_radius);
    EXPECT_NEAR(triple.area[m], static_cast<double>(corner.area), 4e-15 * r * largest) << m;
    EXPECT_NEAR(triple.volume[m], static_cast<double>(corner.volume), 4e-15 * r * r * largest) << m;
  }
}

GrownBall random_ball(Random& random, int extent, int low, int high) {
  const auto at = [&] { return random_int(random, -extent, extent); };
  return grown_ball({at(), at(), at()}, random_int(random, low, high), 0);
}

TEST(BallTriple, IsThatOf113Bits) {
  Random random(1);
  for (int n = 0; n < 400; ++n) {
    expect_triple({random_ball(random, 1500, 1000, 2500), random_ball(random, 1500, 1000, 2500),
                   random_ball(random, 1500, 1000, 2500)});
  }
}

// Small integers often touch, from outside and inside. Shifted by a unit, they nearly touch.
TEST(BallTriple, OfTangentAndNearlyTangentBallsIsThatOf113Bits) {
  Random random(2);
  for (int n = 0; n < 2000; ++n) {
    GrownBall ball[3];
    for (GrownBall& b : ball) {
      const GrownBall small = random_ball(random, 3, 1, 5);
      const int factor = 100000, off = random_int(random, -1, 1);
      b = grown_ball({small.x * factor, small.y * factor, small.z * factor},
                     small.radius * factor + off, 0);
    }
    expect_triple(ball);
  }
}

TEST(BallTriple, OfBallsThatTouchOnTheThirdIsThatOf113Bits) {
  Random random(6);
  for (int n = 0; n < 2000; ++n) {
    const BallSet set = testing::balls_through_a_point(random, 3, 10000);
    GrownBall ball[3];
    for (BallIndex m = 0; m < 3; ++m) ball[m] = grown_ball(set.centres[m], set.radii[m], 0);
    expect_triple(ball);
  }
}

TEST(BallTriple, OfRadiiOfAllSizesIsThatOf113Bits) {
  Random random(3);
  for (int n = 0; n < 2000; ++n) {
    GrownBall ball[3];
    for (GrownBall& b : ball) {
      const int size = 1 << random_int(random, 3, 20);
      b = random_ball(random, size, size / 2, size);
    }
    expect_triple(ball);
  }
}

TEST(BallPair, CapsOfTouchingBallsAreNoneOrAll) {
  const GrownBall large = grown_ball({0, 0, 0}, 2000, 0),
                  outside = grown_ball({3000, 0, 0}, 1000, 0),
                  inside = grown_ball({1000, 0, 0}, 1000, 0);
  const BallPair apart = ball_pair(large, outside), within = ball_pair(large, inside);
  EXPECT_EQ(apart.square_disc, 0);
  EXPECT_EQ(cap_height(apart, 0, 2000), 0);
  EXPECT_EQ(cap_height(apart, 1, 1000), 0);
  EXPECT_EQ(within.square_disc, 0);
  EXPECT_EQ(cap_height(within, 0, 2000), 0);
  EXPECT_EQ(cap_height(within, 1, 1000), 2000);
  EXPECT_DOUBLE_EQ(cap_area(1000, 2000), sphere_area(1000));
  EXPECT_DOUBLE_EQ(cap_volume(1000, 2000), ball_volume(1000));
  EXPECT_DOUBLE_EQ(cap_volume(1000, 1000), ball_volume(1000) / 2);
}

TEST(Angles, OfRegularAndRightCornersAreKnown) {
  const Vector3<double> a = {1, 1, 1}, b = {1, -1, -1}, c = {-1, 1, -1};
  EXPECT_NEAR(
      dihedral_angle(Vector3<double>{2, 0, 0}, Vector3<double>{0, 3, 0}, Vector3<double>{1, 0, 4}),
      kPi / 2, 1e-15);
  EXPECT_NEAR(
      solid_angle(Vector3<double>{1, 0, 0}, Vector3<double>{0, 2, 0}, Vector3<double>{0, 0, 3}),
      kPi / 2, 1e-15);
  EXPECT_NEAR(solid_angle(a, b, c), kPi, 1e-15);  // a quarter of the sphere
  const GrownBall ball[4] = {grown_ball({1, 1, 1}, 1, 0), grown_ball({1, -1, -1}, 1, 0),
                             grown_ball({-1, 1, -1}, 1, 0), grown_ball({-1, -1, 1}, 1, 0)};
  const BallTetrahedron t = ball_tetrahedron(ball);
  for (int e = 0; e < 6; ++e) EXPECT_NEAR(dihedral_at(t, e), std::acos(1.0 / 3), 1e-15);
}

using Exact = std::array<mpq_class, 3>;
mpq_class dot(const Exact& a, const Exact& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
mpq_class determinant(const Exact& a, const Exact& b, const Exact& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The orthoschemes of ball p over all orders of the other balls, by their corners.
struct ExactTetrahedron {
  std::array<Exact, 4> at;
  std::array<mpq_class, 4> weight;

  explicit ExactTetrahedron(const GrownBall (&ball)[4]) {
    for (std::size_t m = 0; m < 4; ++m) {
      at[m] = {mpq_class(ball[m].x), mpq_class(ball[m].y), mpq_class(ball[m].z)};
      weight[m] = mpq_class(ball[m].radius) * ball[m].radius;
    }
  }
  Exact to(std::size_t p, std::size_t q) const {
    return {at[q][0] - at[p][0], at[q][1] - at[p][1], at[q][2] - at[p][2]};
  }
  // The orthocentre of p and others, relative to p.
  Exact centre(std::size_t p, const std::vector<std::size_t>& others) const {
    const std::size_t n = others.size();
    std::vector<Exact> v;
    std::vector<std::vector<mpq_class>> rows(n, std::vector<mpq_class>(n + 1));
    for (const std::size_t q : others) v.push_back(to(p, q));
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t c = 0; c < n; ++c) rows[r][c] = dot(v[r], v[c]);
      rows[r][n] = (dot(v[r], v[r]) + weight[p] - weight[others[r]]) / 2;
    }
    for (std::size_t c = 0; c < n; ++c) {  // positive definite: no pivoting
      for (std::size_t r = 0; r < n; ++r) {
        if (r == c) continue;
        const mpq_class factor = rows[r][c] / rows[c][c];
        for (std::size_t k = c; k <= n; ++k) rows[r][k] -= factor * rows[c][k];
      }
    }
    Exact z = {0, 0, 0};
    for (std::size_t c = 0; c < n; ++c) {
      const mpq_class s = rows[c][n] / rows[c][c];
      for (std::size_t x = 0; x < 3; ++x) z[x] += s * v[c][x];
    }
    return z;
  }
  // The share, and the sum of magnitudes.
  std::array<mpq_class, 2> share(std::size_t p) const {
    std::vector<std::size_t> order;
    for (std::size_t q = 0; q < 4; ++q) {
      if (q != p) order.push_back(q);
    }
    mpq_class sum = 0, magnitudes = 0;
    do {
      const mpq_class volume =
          determinant(centre(p, {order[0]}), centre(p, {order[0], order[1]}), centre(p, order)) / 6;
      sum += volume * sgn(determinant(to(p, order[0]), to(p, order[1]), to(p, order[2])));
      magnitudes += abs(volume);
    } while (std::next_permutation(order.begin(), order.end()));
    return {sum, magnitudes};
  }
};

void expect_shares(const GrownBall (&ball)[4]) {
  const ExactTetrahedron exact(ball);
  const mpq_class volume = determinant(exact.to(0, 1), exact.to(0, 2), exact.to(0, 3)) / 6;
  if (volume == 0) return;
  const BallTetrahedron t = ball_tetrahedron(ball);
  double share[4];
  mpq_class sum = 0;
  orthoscheme_shares(t, share);
  for (std::size_t p = 0; p < 4; ++p) {
    const auto [value, magnitude] = exact.share(p);
    EXPECT_NEAR(share[p], value.get_d(), 1e-13 * magnitude.get_d());
    sum += value;
  }
  EXPECT_EQ(sum, abs(volume));  // the exact shares are right
}

TEST(OrthoschemeShares, AreExact) {
  Random random(4);
  for (int n = 0; n < 300; ++n) {
    expect_shares({random_ball(random, 2000, 1000, 2000), random_ball(random, 2000, 1000, 2000),
                   random_ball(random, 2000, 1000, 2000), random_ball(random, 2000, 1000, 2000)});
  }
}

// Four balls that are flat up to a unit, with edges of up to a million units.
TEST(OrthoschemeShares, OfFlatTetrahedraAreExact) {
  Random random(5);
  for (int n = 0; n < 300; ++n) {
    const int size = n % 2 == 0 ? 1000 : 1000000;
    GrownBall ball[4];
    for (int m = 0; m < 4; ++m) {
      const GrownBall b = random_ball(random, size, size, 2 * size);
      ball[m] = grown_ball({b.x, b.y, b.x + 2 * b.y + random_int(random, 0, 1)}, b.radius, 0);
    }
    expect_shares(ball);
  }
}

}  // namespace
}  // namespace alphascope
