// SPDX-License-Identifier: GPL-3.0-or-later
// Tests drawings in the plane: cells and circles against their definitions, edges by their
// triangles, and well-formed files.
#include "core/chart/flat_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/chart/flat_svg.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/well_formed_xml.hpp"

namespace alphascope {
namespace {

using testing::Random;

BallSet flat(BallSet balls) {
  for (LatticePoint& p : balls.centres) p.z = 0;
  return balls;
}

double power(const BallSet& balls, BallIndex i, const FlatPoint& x) {
  const double dx = x[0] - balls.lattice.angstrom(balls.centres[i].x);
  const double dy = x[1] - balls.lattice.angstrom(balls.centres[i].y);
  const double r = balls.lattice.angstrom(balls.radii[i]);
  return dx * dx + dy * dy - r * r;
}

double area(const std::vector<FlatPoint>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

AlphaComplex complex_of(const BallSet& balls, double alpha_angstrom2) {
  const double alpha = balls.lattice.alpha_on_lattice(alpha_angstrom2).nearest();
  return make_cpu_engine(std::make_shared<const BallSet>(balls), {1})->compute({alpha}, {});
}

std::size_t count(const std::vector<FlatShape>& shapes, FlatKind kind) {
  return static_cast<std::size_t>(std::count_if(
      shapes.begin(), shapes.end(), [kind](const FlatShape& shape) { return shape.kind == kind; }));
}

TEST(FlatDrawing, CellsAreWhereTheirBallHasTheLeastPower) {
  Random random(71);
  for (int round = 0; round < 20; ++round) {
    const BallSet balls = flat(testing::random_balls(random, 30, 40, 1, 12));
    const FlatBox box = box_of(balls, 0);
    double sum = 0;
    for (BallIndex i = 0; i < balls.size(); ++i) {
      const auto cell = power_cell(balls, i, box);
      const double cell_area = area(cell);
      EXPECT_GE(cell_area, 0);
      sum += cell_area;
      if (cell.empty()) continue;
      FlatPoint middle{};
      for (const FlatPoint& corner : cell) {
        middle[0] += corner[0] / static_cast<double>(cell.size());
        middle[1] += corner[1] / static_cast<double>(cell.size());
      }
      for (BallIndex other = 0; other < balls.size(); ++other) {
        EXPECT_LE(power(balls, i, middle), power(balls, other, middle) + 1e-9);
      }
    }
    const double whole = box.width() * box.height();
    EXPECT_NEAR(sum, whole, 1e-9 * whole) << "cells fill the box and do not overlap";
  }
}

TEST(FlatDrawing, OneOfSeveralEqualBallsHasTheCell) {
  BallSet balls;
  for (const int radius : {2, 3, 3}) testing::add_ball(balls, 5, 5, 0, radius);
  const FlatBox box{{0, 0}, {1, 1}};
  EXPECT_TRUE(power_cell(balls, 0, box).empty());
  EXPECT_EQ(area(power_cell(balls, 1, box)), 1);
  EXPECT_TRUE(power_cell(balls, 2, box).empty());
}

TEST(FlatDrawing, OrthocirclesHaveOnePowerToTheirBalls) {
  Random random(72);
  int imaginary = 0;
  for (int round = 0; round < 200; ++round) {
    const BallSet balls = flat(testing::random_balls(random, 3, 30, 1, 15));
    for (const std::vector<BallIndex>& of : {std::vector<BallIndex>{1}, {0, 2}, {0, 1, 2}}) {
      const Orthocircle circle = orthocircle(balls, of);
      if (!circle.any) continue;
      imaginary += circle.squared_radius < 0;
      for (const BallIndex ball : of) {
        EXPECT_NEAR(power(balls, ball, circle.centre), circle.squared_radius,
                    1e-6 * (1 + std::fabs(circle.squared_radius)));
      }
    }
  }
  EXPECT_GT(imaginary, 200);
}

TEST(FlatDrawing, ThreeCentresInALineHaveNoOrthocircle) {
  BallSet balls;
  for (const int x : {0, 4, 9}) testing::add_ball(balls, x, 2 * x, 0, 1);
  testing::add_ball(balls, 0, 0, 0, 2);
  EXPECT_FALSE(orthocircle(balls, {0, 1, 2}).any);
  EXPECT_FALSE(orthocircle(balls, {0, 3}).any);
  EXPECT_TRUE(orthocircle(balls, {0, 1}).any);
  EXPECT_FALSE(orthocircle(balls, {}).any);
}

// The square of the orthocircle's radius is a triangle's alpha value, in the plane too.
TEST(FlatDrawing, ATriangleAppearsAtTheSquareOfItsOrthocircle) {
  BallSet balls;
  balls.lattice.digits = 0;
  testing::add_ball(balls, 0, 0, 0, 2);
  testing::add_ball(balls, 10, 0, 0, 3);
  testing::add_ball(balls, 4, 9, 0, 2);
  const double squared = orthocircle(balls, {0, 1, 2}).squared_radius;
  EXPECT_EQ(complex_of(balls, squared - 0.001).triangles.size(), 0u);
  EXPECT_EQ(complex_of(balls, squared + 0.001).triangles.size(), 1u);
}

TEST(FlatDrawing, EdgesAreToldApartByTheirTriangles) {
  BallSet balls;  // a square with a diagonal, and two balls beside it that touch
  balls.lattice.digits = 0;
  for (const auto& [x, y] : {std::pair(0, 0), {10, 0}, {0, 10}, {10, 10}, {40, 0}, {48, 0}}) {
    testing::add_ball(balls, x, y, 0, 4);
  }
  const AlphaComplex complex = complex_of(balls, 60);
  const auto shapes = flat_shapes(balls, complex, box_of(balls, 60));
  EXPECT_EQ(count(shapes, FlatKind::triangle), 2u);
  EXPECT_EQ(count(shapes, FlatKind::edge_boundary), 4u);
  EXPECT_EQ(count(shapes, FlatKind::edge_inside), 1u);
  EXPECT_EQ(count(shapes, FlatKind::edge_alone), 1u);
  EXPECT_EQ(count(shapes, FlatKind::grown_disc), 6u);
  EXPECT_EQ(count(shapes, FlatKind::vertex), 6u);
}

TEST(FlatDrawing, HiddenAndVanishedBallsHaveNoVertex) {
  BallSet balls;
  balls.lattice.digits = 0;
  testing::add_ball(balls, 0, 0, 0, 20);
  testing::add_ball(balls, 3, 0, 0, 2);  // hidden by the first
  const auto shapes = flat_shapes(balls, complex_of(balls, 0), box_of(balls, 0));
  EXPECT_EQ(count(shapes, FlatKind::vertex), 1u);
  EXPECT_EQ(count(shapes, FlatKind::no_vertex), 1u);
  EXPECT_EQ(count(shapes, FlatKind::cell), 1u);
  const auto shrunk = flat_shapes(balls, complex_of(balls, -5), box_of(balls, -5));
  EXPECT_EQ(count(shrunk, FlatKind::empty_ball), 1u);
  EXPECT_EQ(count(shrunk, FlatKind::grown_disc), 1u);
}

TEST(FlatDrawing, WorksForNoBallsOneAndManyInALine) {
  for (const int n : {0, 1, 5}) {
    BallSet balls;
    balls.lattice.digits = 0;
    for (int i = 0; i < n; ++i) testing::add_ball(balls, 3 * i, 0, 0, 2);
    const FlatBox box = box_of(balls, 1);
    EXPECT_GT(box.width(), 0);
    EXPECT_GT(box.height(), 0);
    const auto shapes = flat_shapes(balls, complex_of(balls, 1), box);
    EXPECT_EQ(count(shapes, FlatKind::cell), static_cast<std::size_t>(n));
    EXPECT_EQ(count(shapes, FlatKind::edge_alone), static_cast<std::size_t>(std::max(0, n - 1)));
  }
}

TEST(FlatDrawing, RefusesBallsOutsideThePlane) {
  BallSet balls;
  testing::add_ball(balls, 0, 0, 1, 20);
  EXPECT_FALSE(is_flat(balls));
  EXPECT_THROW(flat_shapes(balls, {}, {{0, 0}, {1, 1}}), std::invalid_argument);
}

// The box contains the grown discs, and a margin of 8 % of the longer side.
TEST(FlatDrawing, ABoxHasAMargin) {
  BallSet balls;
  balls.lattice.digits = 0;
  testing::add_ball(balls, 0, 0, 0, 3);
  testing::add_ball(balls, 10, 0, 0, 3);
  const FlatBox box = box_of(balls, 16);  // radii √(9 + 16): from -5 to 15 and from -5 to 5
  EXPECT_NEAR(box.low[0], -5 - 1.6, 1e-12);
  EXPECT_NEAR(box.high[0], 15 + 1.6, 1e-12);
  EXPECT_NEAR(box.low[1], -5 - 1.6, 1e-12);
  EXPECT_NEAR(box.high[1], 5 + 1.6, 1e-12);
}

// For two balls of radius 1 at distance d the square is (d / 2)² - 1.
TEST(FlatDrawing, ASmallOrthocircleIsDrawnAndAnImaginaryOneIsNot) {
  BallSet balls;
  balls.lattice.digits = 1;
  testing::add_ball(balls, 0, 0, 0, 10);
  testing::add_ball(balls, 22, 0, 0, 10);  // 1.21 - 1 = 0.21
  testing::add_ball(balls, 0, 100, 0, 10);
  testing::add_ball(balls, 18, 100, 0, 10);  // 0.81 - 1
  const FlatBox box = box_of(balls, 0);
  const AlphaComplex complex = complex_of(balls, 0);
  const auto real = flat_shapes(balls, complex, box, {.chosen = {0, 1}});
  EXPECT_EQ(count(real, FlatKind::orthocentre), 1u);
  ASSERT_EQ(count(real, FlatKind::orthocircle), 1u);
  EXPECT_EQ(real.back().kind, FlatKind::orthocircle);
  EXPECT_NEAR(real.back().radius, std::sqrt(0.21), 1e-12);
  const auto imaginary = flat_shapes(balls, complex, box, {.chosen = {2, 3}});
  EXPECT_EQ(count(imaginary, FlatKind::orthocentre), 1u);
  EXPECT_EQ(count(imaginary, FlatKind::orthocircle), 0u);
}

// A page of 10 x 5 Å at 10 pixels per Å, with y upwards.
TEST(FlatSvg, EachKindLooksAsItsLegendSays) {
  const FlatPage page{{{0, 0}, {10, 5}}, 100};
  const auto drawn = [&](const FlatShape& shape) {
    const std::string svg = flat_svg({shape}, page);
    const std::size_t begin = svg.find("round\">\n") + 8;
    return svg.substr(begin, svg.find("\n</g>") - begin);
  };
  const std::string circle = "<circle cx=\"20.000\" cy=\"40.000\" r=\"";
  const struct {
    FlatKind kind;
    std::string tag;
  } circles[] = {
      {FlatKind::grown_disc,
       "7.000\" fill=\"#2f81c4\" fill-opacity=\"0.16\" stroke=\"#2f81c4\" "
       "stroke-opacity=\"0.55\" stroke-width=\"1.2\"/>"},
      {FlatKind::ball,
       "7.000\" fill=\"none\" stroke=\"#24292f\" stroke-opacity=\"0.85\" stroke-width=\"1.3\"/>"},
      {FlatKind::empty_ball,
       "7.000\" fill=\"none\" stroke=\"#6e7781\" stroke-opacity=\"0.70\" stroke-width=\"1.2\" "
       "stroke-dasharray=\"6 4\"/>"},
      {FlatKind::vertex, "4.000\" fill=\"#1b1f24\" stroke=\"none\" stroke-width=\"0.0\"/>"},
      {FlatKind::no_vertex, "3.500\" fill=\"#ffffff\" stroke=\"#6e7781\" stroke-width=\"1.4\"/>"},
      {FlatKind::orthocircle, "7.000\" fill=\"none\" stroke=\"#c62828\" stroke-width=\"1.8\"/>"},
      {FlatKind::orthocentre, "3.000\" fill=\"#c62828\" stroke=\"none\" stroke-width=\"0.0\"/>"}};
  for (const auto& c : circles) EXPECT_EQ(drawn({c.kind, {{2, 1}}, 0.7, {0}}), circle + c.tag);
  const std::string polygon = "<polygon points=\"0.000,50.000 100.000,50.000 20.000,40.000\"";
  const struct {
    FlatKind kind;
    std::string tag;
  } polygons[] = {
      {FlatKind::cell,
       " fill=\"none\" stroke=\"#6e7781\" stroke-opacity=\"0.90\" stroke-width=\"1.0\" "
       "stroke-dasharray=\"6 4\"/>"},
      {FlatKind::triangle,
       " fill=\"#2da160\" fill-opacity=\"0.35\" stroke=\"none\" stroke-width=\"0.0\"/>"},
      {FlatKind::edge_inside,
       " fill=\"none\" stroke=\"#1a7f45\" stroke-opacity=\"0.80\" stroke-width=\"1.4\"/>"},
      {FlatKind::edge_boundary, " fill=\"none\" stroke=\"#116235\" stroke-width=\"2.8\"/>"},
      {FlatKind::edge_alone, " fill=\"none\" stroke=\"#b07700\" stroke-width=\"2.4\"/>"}};
  for (const auto& p : polygons) {
    EXPECT_EQ(drawn({p.kind, {{0, 0}, {10, 0}, {2, 1}}, 0, {0}}), polygon + p.tag);
  }
}

TEST(FlatDrawing, IsAWellFormedFile) {
  Random random(73);
  const BallSet balls = flat(testing::random_balls(random, 12, 20, 1, 6));
  const FlatBox box = box_of(balls, 4);
  const auto shapes = flat_shapes(balls, complex_of(balls, 4), box, {.chosen = {0, 1, 2}});
  const std::string svg =
      flat_svg(shapes, {box, 800, {"α = 4 Å² & <more>"}, {{"file", "a<b>.xyzr"}}});
  EXPECT_EQ(test::xml_error(svg), "");
  EXPECT_NE(svg.find("α = 4 Å² &amp; &lt;more&gt;"), std::string::npos);
  EXPECT_NE(svg.find("file: a&lt;b&gt;.xyzr"), std::string::npos);
  std::size_t circles = 0;
  for (std::size_t at = 0; (at = svg.find("<circle", at)) != std::string::npos; ++at) ++circles;
  EXPECT_EQ(circles, static_cast<std::size_t>(
                         std::count_if(shapes.begin(), shapes.end(),
                                       [](const FlatShape& s) { return s.points.size() == 1; })));
}

}  // namespace
}  // namespace alphascope
