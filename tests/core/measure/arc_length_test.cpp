// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the length of the arcs in which the spheres of a union meet, against closed forms and
// against points sampled on circles without a complex.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/ball_geometry.hpp"
#include "tests/core/measure/measured_sets.hpp"

namespace alphascope {
namespace {

using testing::balls_of_file;
using testing::measured;
using testing::Random;

constexpr MeasuredQuantity kArcs = MeasuredQuantity::arc_length;

BallSet balls_of(std::initializer_list<std::array<int, 4>> rows, int digits = 0) {
  BallSet balls;
  balls.lattice.digits = digits;
  for (const auto& row : rows) testing::add_ball(balls, row[0], row[1], row[2], row[3]);
  return balls;
}
double total(const BallSet& balls, double alpha = 0) {
  return measured(balls, alpha).total[kArcs];
}

TEST(ArcLength, OfTwoBallsIsTheirCircle) {
  const UnionMeasures of = measured(balls_of({{0, 0, 0, 5}, {6, 0, 0, 4}}));
  const double circle = 2 * kPi * std::sqrt(25 - 3.75 * 3.75);
  EXPECT_NEAR(of.total[kArcs], circle, 1e-12);
  EXPECT_NEAR(of.of_ball[kArcs][0], circle / 2, 1e-12);
  EXPECT_NEAR(of.of_ball[kArcs][1], circle / 2, 1e-12);
  // Alpha grows the squared radius of the circle.
  EXPECT_NEAR(total(balls_of({{0, 0, 0, 5}, {6, 0, 0, 4}}), 2),
              2 * kPi * std::sqrt(27 - 3.75 * 3.75), 1e-12);
}

TEST(ArcLength, OfTangentHiddenAndEqualBallsIsZero) {
  for (const BallSet& balls :
       {balls_of({{0, 0, 0, 5}}), balls_of({{0, 0, 0, 5}, {9, 0, 0, 4}}),
        balls_of({{0, 0, 0, 1}, {1, 2, 2, 2}}), balls_of({{0, 0, 0, 5}, {3, 0, 0, 2}}),
        balls_of({{0, 0, 0, 5}, {1, 0, 0, 2}, {0, 0, 0, 5}}), balls_of({{1, 1, 1, 0}})}) {
    EXPECT_EQ(total(balls), 0);
  }
}

// Three balls of radius R at distances a. The third covers the angle 2 acos(a / sqrt(12) r) of the
// circle of the other two, of radius r.
TEST(ArcLength, OfThreeBallsIsKnown) {
  const double a = std::sqrt(32.0), r = std::sqrt(25 - 8.0);
  const double covered = 2 * std::acos(a / (std::sqrt(12.0) * r));
  const UnionMeasures of = measured(balls_of({{0, 0, 0, 5}, {4, 4, 0, 5}, {4, 0, 4, 5}}));
  EXPECT_NEAR(of.total[kArcs], 3 * r * (2 * kPi - covered), 1e-12);
  for (const double half : of.of_ball[kArcs]) EXPECT_NEAR(half, of.total[kArcs] / 3, 1e-12);
}

// A regular tetrahedron: filled, or with four singular triangles and its middle open.
TEST(ArcLength, OfFourBallsIsKnown) {
  const double a = std::sqrt(32.0), angle = std::acos(1 / 3.0);
  const auto four = [](int radius) {
    return balls_of(
        {{0, 0, 0, radius}, {40, 40, 0, radius}, {40, 0, 40, radius}, {0, 40, 40, radius}}, 1);
  };
  const double large = std::sqrt(16 - 8.0), small = std::sqrt(3.3 * 3.3 - 8);
  const double by_large = std::acos(a / (std::sqrt(12.0) * large)),
               by_small = std::acos(a / (std::sqrt(12.0) * small));
  EXPECT_NEAR(total(four(40)), 6 * large * (2 * kPi - angle - 2 * by_large), 1e-11);
  EXPECT_NEAR(total(four(33)), 6 * small * (2 * kPi - 4 * by_small), 1e-11);
}

// Four centres on a circle: the diagonal of the complex has a circle, but no arc.
TEST(ArcLength, OfAFlatSquareIsThatOfItsSides) {
  const double r = std::sqrt(9 - 4.0), covered = 2 * std::acos(2 / r);
  EXPECT_NEAR(total(balls_of({{0, 0, 0, 3}, {4, 0, 0, 3}, {4, 4, 0, 3}, {0, 4, 0, 3}})),
              4 * r * (2 * kPi - covered), 1e-11);
}

using Place = std::array<double, 3>;
struct Sphere {
  Place at;
  double radius;
};
double square_distance(const Place& a, const Place& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

// Lengths by evenly spread points on the circle of each pair of spheres. Points within another ball
// do not count. Each circle begins anywhere.
struct Sampled {
  std::vector<double> half, variance;
};
class Sampling {
 public:
  Sampling(std::vector<Sphere> spheres, Random& random)
      : spheres_(std::move(spheres)), random_(random) {}

  Sampled sampled(int points) {
    const std::size_t n = spheres_.size();
    Sampled of{std::vector<double>(n), std::vector<double>(n)};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) add_circle(i, j, points, of);
    }
    return of;
  }

 private:
  void add_circle(std::size_t i, std::size_t j, int points, Sampled& to) {
    const Sphere &a = spheres_[i], &b = spheres_[j];
    const double square = square_distance(a.at, b.at), d = std::sqrt(square);
    if (d >= a.radius + b.radius || d <= std::fabs(a.radius - b.radius)) return;
    const double h = (square + a.radius * a.radius - b.radius * b.radius) / (2 * d);
    const double r = std::sqrt(a.radius * a.radius - h * h);
    Place along, middle;
    for (int k = 0; k < 3; ++k) along[k] = (b.at[k] - a.at[k]) / d;
    for (int k = 0; k < 3; ++k) middle[k] = a.at[k] + h * along[k];
    const int free = free_points(i, j, {middle, r}, along, points);
    const double step = 2 * kPi * r / points;
    for (const std::size_t ball : {i, j}) {
      to.half[ball] += step * free / 2;
      if (free > 0 && free < points) to.variance[ball] += step * step;
    }
  }
  int free_points(std::size_t i, std::size_t j, const Sphere& circle, const Place& along,
                  int points) {
    const int axis = std::fabs(along[0]) < 0.6 ? 0 : 1;
    Place u = {}, v;
    u[axis] = 1;
    const double part = along[axis];
    for (int k = 0; k < 3; ++k) u[k] -= part * along[k];
    const double length = std::sqrt(square_distance(u, {}));
    for (double& x : u) x /= length;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      v[k] = along[l] * u[m] - along[m] * u[l];
    }
    std::vector<Sphere> others;
    for (std::size_t k = 0; k < spheres_.size(); ++k) {
      const double reach = circle.radius + spheres_[k].radius;
      if (k != i && k != j && square_distance(circle.at, spheres_[k].at) < reach * reach) {
        others.push_back(spheres_[k]);
      }
    }
    const double start = std::uniform_real_distribution<double>(0, 1)(random_);
    int free = 0;
    for (int p = 0; p < points; ++p) {
      const double turn = 2 * kPi * (p + start) / points;
      const double c = circle.radius * std::cos(turn), s = circle.radius * std::sin(turn);
      Place at;
      for (int k = 0; k < 3; ++k) at[k] = circle.at[k] + c * u[k] + s * v[k];
      free += std::none_of(others.begin(), others.end(), [&](const Sphere& o) {
        return square_distance(at, o.at) < o.radius * o.radius;
      });
    }
    return free;
  }

  const std::vector<Sphere> spheres_;
  Random& random_;
};

std::vector<Sphere> spheres_of(const BallSet& balls, double alpha) {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    const double r = balls.lattice.angstrom(balls.radii[i]);
    const Place at = {balls.lattice.angstrom(p.x), balls.lattice.angstrom(p.y),
                      balls.lattice.angstrom(p.z)};
    spheres.push_back({at, std::sqrt(std::max(0.0, r * r + alpha))});
  }
  return spheres;
}

// Sampling errs by less than one step for each arc, and may miss an arc shorter than a step. So the
// error is practically never above six times the root of the sum of squared steps.
void expect_sampled(const BallSet& balls, double alpha, int points, Random& random) {
  const UnionMeasures of = measured(balls, alpha);
  const std::vector<Sphere> spheres = spheres_of(balls, alpha);
  const Sampled by_points = Sampling(spheres, random).sampled(points);
  double sum = 0, variance = 0;
  ASSERT_EQ(of.of_ball[kArcs].size(), balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double missed = kPi * spheres[i].radius / points;
    const double of_ball = by_points.variance[i] + missed * missed / 36;
    EXPECT_NEAR(of.of_ball[kArcs][i], by_points.half[i], 6 * std::sqrt(of_ball)) << i;
    sum += by_points.half[i];
    variance += of_ball;
  }
  EXPECT_GT(sum, 0);
  EXPECT_NEAR(of.total[kArcs], sum, 6 * std::sqrt(2 * variance));
}

TEST(ArcLength, OfRandomBallsIsThatOfSampledPoints) {
  Random random(17);
  for (int n = 0; n < 4; ++n) {
    SCOPED_TRACE(n);
    BallSet balls = testing::random_balls(random, 60, 900, 100, 400);
    balls.lattice.digits = 3;
    expect_sampled(balls, (n - 1) * 0.005, 2000, random);
  }
}

TEST(ArcLength, OfAProteinIsThatOfSampledPoints) {
  Random random(18);
  expect_sampled(with_solvent(balls_of_file("1crn.xyzr"), 1.4), 0, 1000, random);
}

}  // namespace
}  // namespace alphascope
