// SPDX-License-Identifier: GPL-3.0-or-later
// Tests points in triangulations by trying all tetrahedra in rationals.
#include "core/cavity_identity/point_location.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/cavity/rational_location.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

void expect_found(const BallSet& balls, const Triangulation& triangulation,
                  const LatticePlace& place, std::size_t& inside) {
  const PointLocator locator(balls, triangulation);
  const std::vector<std::uint32_t> all = testing::tetrahedra_at(balls, triangulation, place);
  ASSERT_LE(all.size(), 1u);
  const std::uint32_t expected = all.empty() ? PointLocator::kOutside : all[0];
  inside += !all.empty();
  ASSERT_EQ(locator.find(place), expected);
  for (std::uint32_t start = 0; start < triangulation.tetrahedra.size(); start += 3) {
    ASSERT_EQ(locator.find(place, start), expected) << "from " << start;
  }
}

TEST(PointLocation, PointsOfALatticeOnFacesEdgesAndVerticesAreInOneTetrahedron) {
  Random random(7);
  std::size_t inside = 0, points = 0;
  for (int round = 0; round < 120; ++round) {
    BallSet balls;
    const int count = testing::random_int(random, 5, 14);
    for (int n = 0; n < count; ++n) {
      testing::add_ball(balls, 2 * testing::random_int(random, 0, 2),
                        2 * testing::random_int(random, 0, 2),
                        2 * testing::random_int(random, 0, 2), testing::random_int(random, 1, 2));
    }
    const Triangulation triangulation = make_triangulation(balls, 1);
    for (int n = 0; n < 30; ++n) {
      const LatticePlace place{testing::random_int(random, -1, 5),
                               testing::random_int(random, -1, 5),
                               testing::random_int(random, -1, 5), 1};
      expect_found(balls, triangulation, place, inside);
      ++points;
    }
  }
  EXPECT_GT(inside, 150u);
  EXPECT_LT(inside, points);
}

TEST(PointLocation, CentroidsAreInTheirTetrahedra) {
  const auto balls = testing::sample_balls("1crn.pdb", 1.4);
  const Triangulation triangulation = make_triangulation(*balls, 1);
  const PointLocator locator(*balls, triangulation);
  ASSERT_GT(triangulation.tetrahedra.size(), 1000u);
  for (std::uint32_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
    LatticePlace centroid{0, 0, 0, 4};
    for (const BallIndex v : triangulation.tetrahedra[t]) {
      centroid.x += balls->centres[v].x;
      centroid.y += balls->centres[v].y;
      centroid.z += balls->centres[v].z;
    }
    ASSERT_EQ(locator.find(centroid), t);
    ASSERT_EQ(locator.find(centroid, 0), t);
  }
}

TEST(PointLocation, TheOrderOfTheBallsDoesNotMatter) {
  Random random(8);
  BallSet balls;
  for (int n = 0; n < 40; ++n) {
    testing::add_ball(balls, 3 * testing::random_int(random, 0, 3),
                      3 * testing::random_int(random, 0, 3), 3 * testing::random_int(random, 0, 3),
                      testing::random_int(random, 1, 3));
  }
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  const BallSet other = testing::permuted(balls, order);
  const Triangulation a = make_triangulation(balls, 1), b = make_triangulation(other, 1);
  const PointLocator in_a(balls, a), in_b(other, b);
  const auto corners = [](const BallSet& set, const Triangulation& of, std::uint32_t t) {
    std::vector<LatticePoint> points;
    if (t == PointLocator::kOutside) return points;
    for (const BallIndex v : of.tetrahedra[t]) points.push_back(set.centres[v]);
    std::sort(points.begin(), points.end());
    return points;
  };
  for (int n = 0; n < 1000; ++n) {
    const LatticePlace place{n % 10, n / 10 % 10, n / 100, 1};
    EXPECT_EQ(corners(balls, a, in_a.find(place)), corners(other, b, in_b.find(place)));
  }
}

TEST(PointLocation, FarAwayAndBelowDimension3IsOutside) {
  BallSet balls;
  const int most = kMaxLatticeCoordinate;
  for (const int x : {-most, most}) {
    for (const int y : {-most, most}) {
      for (const int z : {-most, most}) testing::add_ball(balls, x, y, z, 1);
    }
  }
  const Triangulation cube = make_triangulation(balls, 1);
  const PointLocator in_cube(balls, cube);
  EXPECT_EQ(in_cube.find({std::int64_t{1} << 50, 0, 0, 1}), PointLocator::kOutside);
  EXPECT_EQ(in_cube.find({std::int64_t{most} + 1, 0, 0, 1}), PointLocator::kOutside);
  EXPECT_EQ(in_cube.find({most, 0, 0, 1}), PointLocator::kOutside);  // moved out along x
  EXPECT_NE(in_cube.find({-most, 0, 0, 1}), PointLocator::kOutside);
  EXPECT_NE(in_cube.find({4 * std::int64_t{most} - 1, 4 * std::int64_t{most} - 1,
                          4 * std::int64_t{most} - 1, 4}),
            PointLocator::kOutside);
  BallSet plane;
  for (int n = 0; n < 5; ++n) testing::add_ball(plane, n * n, n, 0, 2);
  const Triangulation flat = make_triangulation(plane, 1);
  EXPECT_EQ(PointLocator(plane, flat).find({1, 1, 0, 1}), PointLocator::kOutside);
}

TEST(PointLocation, AFinerLatticeHoldsThePointsOfACoarserOne) {
  const LatticePlace place = place_on({5}, {1, -2, kMaxLatticeCoordinate}, {3});
  EXPECT_EQ(place.x, 100);
  EXPECT_EQ(place.y, -200);
  EXPECT_EQ(place.z, std::int64_t{kMaxLatticeCoordinate} * 100);
  EXPECT_EQ(place.times, 1);
}

}  // namespace
}  // namespace alphascope
