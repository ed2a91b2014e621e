// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the neighbourhood of atoms and simplices against the plain definition. Every simplex of
// random complexes is compared, and some that are not in them.
#include "core/document/explain/simplex_details.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/engine/engine.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/radii/amber_radii.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

std::vector<Balls> all_simplices(const AlphaComplex& complex) {
  std::vector<Balls> all;
  const auto add = [&](const auto& list) {
    for (const auto& s : list.simplices) all.emplace_back(s.begin(), s.end());
  };
  add(complex.vertices);
  add(complex.edges);
  add(complex.triangles);
  add(complex.tetrahedra);
  return all;
}

void expect_right(const BallSet& balls, const AlphaComplex& complex, const Balls& simplex) {
  const SimplexDetails found = find_details(balls, complex, simplex);
  EXPECT_EQ(found.balls, simplex);
  std::array<std::size_t, 4> cofaces{};
  std::set<BallIndex> neighbours;
  std::set<Balls> beside;
  bool there = false;
  for (const Balls& other : all_simplices(complex)) {
    const bool has = std::includes(other.begin(), other.end(), simplex.begin(), simplex.end());
    there |= has;
    if (has && other.size() > simplex.size()) ++cofaces[other.size() - 1];
    if (has && other.size() == simplex.size() + 1 && simplex.size() > 1) beside.insert(other);
    Balls common;
    std::set_intersection(other.begin(), other.end(), simplex.begin(), simplex.end(),
                          std::back_inserter(common));
    if (simplex.size() == 4 && other.size() == 4 && common.size() == 3) beside.insert(other);
    const bool joins = other.size() == 2 || complex.tetrahedra_only;
    if (has && joins && simplex.size() == 1) neighbours.insert(other.begin(), other.end());
  }
  neighbours.erase(simplex[0]);
  EXPECT_EQ(found.in_complex, there);
  EXPECT_EQ(found.cofaces, cofaces);
  EXPECT_EQ(std::set<Balls>(found.beside.begin(), found.beside.end()), beside);
  std::set<BallIndex> ends;
  double last = 0;
  for (const NeighbourBall& n : found.neighbours) {
    const LatticePoint &a = balls.centres[simplex[0]], &b = balls.centres[n.ball];
    EXPECT_NEAR(n.distance_angstrom, std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), 1e-9);
    EXPECT_GE(n.distance_angstrom, last) << "the nearest comes first";
    last = n.distance_angstrom;
    ends.insert(n.ball);
  }
  EXPECT_EQ(ends, neighbours);
}

TEST(SimplexDetails, AgreeWithTheDefinition) {
  testing::Random random(3);
  for (int round = 0; round < 4; ++round) {
    const auto balls = std::make_shared<const BallSet>(testing::random_balls(random, 30, 12, 2, 6));
    for (const bool tetrahedra_only : {false, true}) {
      const AlphaComplex complex = make_cgal_engine(balls)->compute({40, tetrahedra_only}, {});
      ASSERT_GT(complex.tetrahedra.size(), 10u);
      for (const Balls& simplex : all_simplices(complex)) expect_right(*balls, complex, simplex);
      for (BallIndex ball = 0; ball < 30; ++ball) {
        expect_right(*balls, complex, {ball});
        if (ball < 29) expect_right(*balls, complex, {ball, ball + 1});
      }
    }
  }
}

TEST(SimplexDetails, HaveTheClassAndTheAlphaValue) {
  auto balls = std::make_shared<BallSet>();
  balls->lattice.digits = 0;
  testing::add_ball(*balls, 0, 0, 0, 1);
  testing::add_ball(*balls, 6, 0, 0, 1);
  testing::add_ball(*balls, 40, 0, 0, 1);
  const AlphaComplex complex = make_cgal_engine(balls)->compute({10, false}, {});
  const SimplexDetails edge = find_details(*balls, complex, {0, 1});
  EXPECT_TRUE(edge.in_complex);
  EXPECT_EQ(edge.simplex_class, SimplexClass::interior) << "on a line nothing is larger";
  EXPECT_EQ(edge.alpha_value_angstrom2, 8) << "3² − 1²";
  const SimplexDetails absent = find_details(*balls, complex, {1, 2});
  EXPECT_FALSE(absent.in_complex);
  EXPECT_FALSE(absent.simplex_class);
  EXPECT_FALSE(absent.alpha_value_angstrom2);
  testing::add_ball(*balls, 40, 50, 0, 1);
  testing::add_ball(*balls, 40, 0, 50, 1);
  const AlphaComplex in_space = make_cgal_engine(balls)->compute({10, false}, {});
  EXPECT_EQ(find_details(*balls, in_space, {0, 1}).simplex_class, SimplexClass::singular);
}

}  // namespace
}  // namespace alphascope
