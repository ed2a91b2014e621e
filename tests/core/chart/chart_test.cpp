// SPDX-License-Identifier: GPL-3.0-or-later
// Tests charts: the places of their parts, and their SVG.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/chart/layout.hpp"
#include "core/chart/readable_number.hpp"
#include "core/chart/svg.hpp"
#include "core/files/atomic_file.hpp"
#include "tests/support/well_formed_xml.hpp"

namespace alphascope {
namespace {

const ChartFont kType{10, [](const std::string& text) { return 5.0f * text.size(); }};

Chart bars() {
  Chart chart;
  chart.id = "bars";
  chart.title = "A & B < C \"quoted\"";
  chart.value_label = "time (ms)";
  chart.categories = {"one", "two"};
  chart.series = {{"a", {1.0, 2.0}}, {"b", {4.0, std::nullopt}, {}, {"", "over 20 s"}}};
  chart.caption = "some machine";
  return chart;
}

Chart lines() {
  Chart chart;
  chart.kind = ChartKind::lines;
  chart.id = "lines";
  chart.x_label = "α (Å²)";
  chart.value_label = "%";
  chart.series = {{"m", {10.0, std::nullopt, 30.0, 20.0}, {0, 1, 2, 4}}};
  return chart;
}

const ChartText* text(const ChartDrawing& drawing, const std::string& what) {
  const auto it = std::find_if(drawing.texts.begin(), drawing.texts.end(),
                               [&](const ChartText& t) { return t.text == what; });
  return it == drawing.texts.end() ? nullptr : &*it;
}

const ChartBox& box(const ChartDrawing& drawing, const std::string& tip) {
  const auto it = std::find_if(drawing.boxes.begin(), drawing.boxes.end(),
                               [&](const ChartBox& b) { return b.tip == tip; });
  if (it == drawing.boxes.end()) throw std::runtime_error("no box " + tip);
  return *it;
}

TEST(Chart, BarsAreAsLongAsTheirValues) {
  const ChartDrawing d = lay_out(bars(), 600, kType);
  const float unit = box(d, "one, a: 1").width;
  EXPECT_NEAR(box(d, "two, a: 2").width, 2 * unit, 0.01);
  EXPECT_NEAR(box(d, "one, b: 4").width, 4 * unit, 0.01);
  EXPECT_EQ(box(d, "one, a: 1").x, box(d, "one, b: 4").x);
  ASSERT_TRUE(text(d, "over 20 s")) << "what was left out says why";
  ASSERT_TRUE(text(d, "time (ms)"));
  ASSERT_TRUE(text(d, "some machine"));
}

// The font has 10 units and letters of 5. Names have 3 letters, with 10 on each side.
TEST(Chart, PartsAreWhereTheTypeSays) {
  Chart chart = bars();
  const ChartDrawing d = lay_out(chart, 600, kType);
  EXPECT_NEAR(box(d, "one, a: 1").x, 35, 0.01);
  EXPECT_NEAR(box(d, "one, a: 1").height, 11.5 * 0.84, 0.01);
  EXPECT_NEAR(box(d, "one, b: 4").y - box(d, "one, a: 1").y, 11.5, 0.01);
  const ChartBox& swatch = box(d, "a");
  EXPECT_NEAR(swatch.y + swatch.height / 2, text(d, "a")->y, 0.01) << "as high as its name";
  EXPECT_NEAR(swatch.width, 8, 0.01);
  chart.categories[0] = std::string(100, 'x');
  const ChartDrawing wide = lay_out(chart, 600, kType);
  EXPECT_NEAR(box(wide, chart.categories[0] + ", a: 1").x, 240, 0.01)
      << "names take two fifths of the width at most";
}

TEST(Chart, TextsAreWrappedWhereTheyDoNotFit) {
  Chart chart = bars();
  const std::string half(57, 'x');
  chart.caption = half + "x " + half;  // 116 letters: 580, from 10 to 590
  EXPECT_TRUE(text(lay_out(chart, 600, kType), chart.caption)) << "it just fits";
  chart.caption = half + "x " + half + "x";
  const ChartDrawing d = lay_out(chart, 600, kType);
  ASSERT_TRUE(text(d, half + "x"));
  EXPECT_FALSE(text(d, chart.caption));
}

TEST(Chart, ZerosHaveAnAxisFromZeroToOne) {
  Chart chart = bars();
  chart.series = {{"a", {0.0, 0.0}}};
  const ChartDrawing d = lay_out(chart, 600, kType);
  ASSERT_TRUE(text(d, "0"));
  ASSERT_TRUE(text(d, "1"));
  EXPECT_NEAR(text(d, "0")->x, 35, 0.01);
  EXPECT_NEAR(box(d, "one, a: 0").x, 35, 0.01);
  EXPECT_NEAR(box(d, "one, a: 0").width, 1, 0.01) << "a line that is seen";
}

TEST(Chart, RatiosFarApartGetALogarithmicAxisFromTheReference) {
  Chart chart = bars();
  chart.ratios = true;
  chart.reference = 1;
  chart.series = {{"a", {100.0, 0.1}}};
  const ChartDrawing d = lay_out(chart, 600, kType);
  const ChartBox &fast = box(d, "one, a: 100"), &slow = box(d, "two, a: 0.1");
  EXPECT_NEAR(slow.x + slow.width, fast.x, 0.01);
  EXPECT_NEAR(fast.width, 2 * slow.width, 0.01);
}

TEST(Chart, NegativeBarsGoToTheLeft) {
  Chart chart = bars();
  chart.series = {{"a", {-3.0, 6.0}}};
  const ChartDrawing d = lay_out(chart, 600, kType);
  const ChartBox &down = box(d, "one, a: −3"), &up = box(d, "two, a: 6");
  EXPECT_NEAR(down.x + down.width, up.x, 0.01);
  EXPECT_NEAR(up.width, 2 * down.width, 0.01);
}

TEST(Chart, StackedSharesAreOneBar) {
  Chart chart = bars();
  chart.kind = ChartKind::stacked_bars;
  chart.series = {{"a", {30.0, 50.0}}, {"b", {70.0, 50.0}}};
  const ChartDrawing d = lay_out(chart, 600, kType);
  const ChartBox &a = box(d, "one, a: 30"), &b = box(d, "one, b: 70");
  EXPECT_NEAR(a.x + a.width, b.x, 0.01);
  EXPECT_NEAR(b.width / a.width, 70.0 / 30, 0.01);
  EXPECT_EQ(a.y, b.y);
  EXPECT_NEAR(a.x, 35, 0.01) << "from zero";
}

TEST(Chart, LinesLeaveAGapWhereNothingWasMeasured) {
  const ChartDrawing d = lay_out(lines(), 600, kType);
  ASSERT_EQ(d.dots.size(), 3u);
  const auto drawn = std::count_if(d.lines.begin(), d.lines.end(),
                                   [](const ChartLine& l) { return l.paint.colour.has_value(); });
  EXPECT_EQ(drawn, 1) << "from 2 to 4 only";
  EXPECT_LT(d.dots[1].y, d.dots[2].y) << "30 is above 20";
  EXPECT_NEAR(d.dots[2].x - d.dots[1].x, d.dots[1].x - d.dots[0].x, 0.01);
  EXPECT_TRUE(text(d, "α (Å²)"));
  EXPECT_TRUE(text(d, "%"));
}

TEST(Chart, NothingLeavesThePicture) {
  for (const Chart& chart : {bars(), lines()}) {
    const ChartDrawing d = lay_out(chart, 500, kType);
    for (const ChartBox& b : d.boxes) {
      EXPECT_GE(b.x, 0);
      EXPECT_LE(b.x + b.width, d.width);
      EXPECT_LE(b.y + b.height, d.height);
    }
    for (const ChartText& t : d.texts) {
      const float width = kType.text_width(t.text);
      const float left = t.anchor == ChartAnchor::start    ? t.x
                         : t.anchor == ChartAnchor::middle ? t.x - width / 2
                                                           : t.x - width;
      EXPECT_GE(left, 0) << t.text;
      EXPECT_LE(left + width, d.width) << t.text;
      EXPECT_LE(t.y, d.height) << t.text;
    }
  }
}

TEST(Chart, AnEmptyOneSaysSo) {
  Chart chart = bars();
  chart.series = {{"a", {std::nullopt, std::nullopt}}};
  EXPECT_TRUE(chart.empty());
  EXPECT_TRUE(text(lay_out(chart, 600, kType), "Nothing was measured for this figure."));
}

TEST(Chart, NumbersHaveThreeDigits) {
  EXPECT_EQ(chart_number(0), "0");
  EXPECT_EQ(chart_number(12.345), "12.3");
  EXPECT_EQ(chart_number(1234.5), "1,234");
  EXPECT_EQ(chart_number(12345678), "12,345,678");
  EXPECT_EQ(chart_number(-1.5e-5), "−1.5·10⁻⁵");
  EXPECT_EQ(chart_number(1e24), "10²⁴");
  EXPECT_EQ(chart_number(0.04567), "0.0457");
  EXPECT_EQ(chart_number(-2.5), "−2.5");
}

TEST(ChartSvg, IsWellFormedAndEscapes) {
  EXPECT_EQ(test::xml_error("<a b=\"1\"><c/>x &amp; y</a>"), "");
  EXPECT_NE(test::xml_error("<a><c></a>"), "") << "the check itself";
  EXPECT_NE(test::xml_error("<a>x & y</a>"), "");
  for (const Chart& chart : {bars(), lines()}) {
    const std::string svg = chart_svg(chart);
    EXPECT_EQ(test::xml_error(svg), "") << svg;
  }
  EXPECT_NE(chart_svg(bars()).find("A &amp; B &lt; C &quot;quoted&quot;"), std::string::npos);
}

TEST(ChartSvg, TextsBeginEndOrHaveTheirMiddleAtTheirPlace) {
  const std::string svg = chart_svg(bars());
  const auto anchor = [&](const std::string& text) {
    const std::size_t end = svg.find(">" + text + "</text>");
    EXPECT_NE(end, svg.npos) << text;
    const std::size_t from = svg.rfind("text-anchor=\"", end) + 13;
    return svg.substr(from, svg.find('"', from) - from);
  };
  EXPECT_EQ(anchor("some machine"), "start");
  EXPECT_EQ(anchor("one"), "end") << "a category, before its bar";
  EXPECT_EQ(anchor("0"), "middle") << "a number, below its mark";
}

TEST(ChartSvg, FilesAreWrittenIntoAFolderThatIsMade) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "alphascope_charts" / "new";
  std::filesystem::remove_all(folder);
  const auto paths = write_charts({bars(), lines()}, folder);
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_EQ(paths[0].filename(), "bars.svg");
  for (const auto& path : paths) EXPECT_GT(std::filesystem::file_size(path), 500u);
  EXPECT_THROW(write_charts({bars()}, paths[0]), WriteError) << "a file is no folder";
  std::filesystem::remove_all(folder.parent_path());
}

}  // namespace
}  // namespace alphascope
