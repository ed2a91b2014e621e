// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the layout of plots and their SVG.
#include "core/chart/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "core/chart/svg.hpp"
#include "tests/support/well_formed_xml.hpp"

namespace alphascope {
namespace {

const ChartFont kType{10, [](const std::string& text) { return 5.0f * text.size(); }, 1};

Plot two_curves() {
  Plot plot;
  plot.x = {.range = {0, 10}, .label = "alpha (Å²)"};
  plot.y = {.range = {-1, 3}, .label = "volume (Å³)"};
  plot.curves.push_back({.name = "a < b", .points = {{0, 0.0}, {5, 2.0}, {10, 1.0}}});
  plot.curves.push_back(
      {.name = "gap", .points = {{0, 1.0}, {4, {}}, {6, 2.0}, {8, {}}, {9, 1.0}, {10, 3.0}}});
  return plot;
}

PlotArea area_of(const Plot& plot) {
  return {50, 20, 450, 220, plot.x.range, plot.y.range};
}

const ChartText* text(const ChartDrawing& drawing, const std::string& what) {
  const auto it = std::find_if(drawing.texts.begin(), drawing.texts.end(),
                               [&](const ChartText& t) { return t.text == what; });
  return it == drawing.texts.end() ? nullptr : &*it;
}

TEST(Plot, PlacesAndValuesAreEachOthersInverse) {
  const PlotArea area = area_of(two_curves());
  EXPECT_FLOAT_EQ(area.x_of(0), 50);
  EXPECT_FLOAT_EQ(area.x_of(10), 450);
  EXPECT_FLOAT_EQ(area.y_of(-1), 220);
  EXPECT_FLOAT_EQ(area.y_of(3), 20);
  EXPECT_NEAR(area.x_at(area.x_of(3.25)), 3.25, 1e-5);
  EXPECT_NEAR(area.y_at(area.y_of(1.75)), 1.75, 1e-5);
  PlotArea turned = area;
  turned.y = {4, 0};  // rows from the top
  EXPECT_FLOAT_EQ(turned.y_of(0), 20);
  EXPECT_NEAR(turned.y_at(70), 1, 1e-5);
}

TEST(Plot, GapsDivideCurvesAndALonePointIsADot) {
  const Plot plot = two_curves();
  const ChartDrawing d = lay_out(plot, area_of(plot), kType);
  ASSERT_EQ(d.paths.size(), 2u);
  EXPECT_EQ(d.paths[0].points.size(), 3u);
  EXPECT_EQ(d.paths[1].points.size(), 2u) << "from 9 to 10";
  ASSERT_EQ(d.dots.size(), 2u) << "at 0 and at 6";
  EXPECT_FLOAT_EQ(d.dots[0].x, 50);
  EXPECT_FLOAT_EQ(d.dots[1].x, 50 + 0.6f * 400);
}

TEST(Plot, PointsBeyondTheAxisAreLeftOut) {
  Plot plot = two_curves();
  plot.x.range = {4, 9.5};
  const ChartDrawing d = lay_out(plot, area_of(plot), kType);
  EXPECT_TRUE(d.paths.empty());
  ASSERT_EQ(d.dots.size(), 3u) << "one of the first curve, at 6 and at 9 of the second";
  for (const ChartDot& dot : d.dots) {
    EXPECT_GE(dot.x, 50);
    EXPECT_LE(dot.x, 450);
  }
}

TEST(Plot, NumbersStandAtTheirValues) {
  Plot plot = two_curves();
  const ChartDrawing d = lay_out(plot, area_of(plot), kType);
  ASSERT_TRUE(text(d, "2"));
  ASSERT_TRUE(text(d, "−1.0"));
  EXPECT_FLOAT_EQ(text(d, "−1.0")->y, 220);
  EXPECT_LT(text(d, "−1.0")->x, 50);
  ASSERT_TRUE(text(d, "10"));
  EXPECT_FLOAT_EQ(text(d, "10")->x, 450);
  EXPECT_GT(text(d, "10")->y, 220);
  EXPECT_TRUE(text(d, "alpha (Å²)"));
  EXPECT_TRUE(text(d, "volume (Å³)"));
  plot.x.unit = "ms";
  EXPECT_TRUE(text(lay_out(plot, area_of(plot), kType), "0 ms"));
  plot.x.numbered = plot.y.numbered = false;
  const ChartDrawing plain = lay_out(plot, area_of(plot), kType);
  EXPECT_EQ(plain.texts.size(), 2u) << "the labels";
}

TEST(Plot, WholeNumbersAndOffsets) {
  Plot plot = two_curves();
  plot.x = {.range = {-0.5, 1.5}, .label = "model", .whole = true, .offset = 1};
  const ChartDrawing d = lay_out(plot, area_of(plot), kType);
  ASSERT_TRUE(text(d, "1"));
  EXPECT_FLOAT_EQ(text(d, "1")->x, 150) << "the first, at 0";
  const auto below =
      std::count_if(d.texts.begin(), d.texts.end(), [](const ChartText& t) { return t.y > 220; });
  EXPECT_EQ(below, 3) << "1, 2 and the label";
}

TEST(Plot, BoxesDotsAndLinesAreWhereTheyShould) {
  Plot plot = two_curves();
  plot.boxes.push_back({2, 4, 0, 1, {ChartColourRole::accent}});
  plot.boxes.push_back({6, 6, 0, 1, {ChartColourRole::accent}});
  plot.dots.push_back({5, 2, {ChartColourRole::accent}, 3.5f, true});
  plot.lines.push_back({7, {ChartColourRole::accent}});
  const ChartDrawing d = lay_out(plot, area_of(plot), kType);
  ASSERT_EQ(d.boxes.size(), 3u) << "with the frame";
  EXPECT_FLOAT_EQ(d.boxes[1].x, 130);
  EXPECT_FLOAT_EQ(d.boxes[1].width, 80);
  EXPECT_FLOAT_EQ(d.boxes[1].y, 120);
  EXPECT_FLOAT_EQ(d.boxes[1].height, 50);
  EXPECT_FLOAT_EQ(d.boxes[2].width, 1) << "an empty one is visible";
  EXPECT_TRUE(d.dots.back().ring);
  ASSERT_EQ(d.paths.back().points.size(), 2u);
  EXPECT_FLOAT_EQ(d.paths.back().points[0].x, 330);
}

TEST(Plot, TheNearestPointIsFound) {
  const Plot plot = two_curves();
  const PlotCurve& curve = plot.curves[0];
  EXPECT_EQ(nearest_point(curve, -3), 0u);
  EXPECT_EQ(nearest_point(curve, 2.5), 0u) << "of two the first";
  EXPECT_EQ(nearest_point(curve, 2.6), 1u);
  EXPECT_EQ(nearest_point(curve, 7.4), 1u);
  EXPECT_EQ(nearest_point(curve, 99), 2u);
  EXPECT_FALSE(nearest_point({}, 0));
}

TEST(Plot, TheSvgIsWellFormedAndHasALegend) {
  Plot plot = two_curves();
  plot.boxes.push_back({2, 4, 0, 1, {ChartColourRole::accent, {}, 0.25f}});
  plot.dots.push_back({5, 2, {ChartColourRole::accent}, 3.5f, true});
  const std::string svg = plot_svg(plot, "A & B");
  EXPECT_EQ(test::xml_error(svg), "") << svg;
  EXPECT_NE(svg.find("A &amp; B"), std::string::npos);
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  EXPECT_NE(svg.find("fill-opacity=\"0.25\""), std::string::npos);
}

}  // namespace
}  // namespace alphascope
