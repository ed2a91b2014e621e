// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the user guide in the whole window: opening, searching, links, keys, copying; and text in
// lines.
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/viewer/jobs/guide_reader.hpp"
#include "app/viewer/resources.hpp"
#include "core/document/guide/guide.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/fitted_text.hpp"
#include "ui/widgets/flowing_text.hpp"

namespace alphascope::testing {
namespace {

class GuideWindow : public ViewerTest {
 protected:
  GuideWindow() : ViewerTest(false, {1280, 800, 1, "test"}) {}
  bool has(const std::string& widget) { return viewer_->widgets().contains(widget); }
  float top_of_text() { return viewer_->widgets().at("guide.text").y0; }
  void open_guide() { run("click menu.Help\nclick menu.help.guide\nwait-idle\nframes 4\n"); }
};

TEST_F(GuideWindow, OpensByTheMenuAndFollowsAHit) {
  open_guide();
  EXPECT_TRUE(has("guide.title.README"));
  for (const char* page : {"opening", "window", "command-line", "troubles", "file-formats"}) {
    EXPECT_TRUE(has(std::string("guide.page.") + page)) << page;
  }
  run("type probe radius\nframes 2\n");
  ASSERT_TRUE(has("guide.hits"));
  EXPECT_FALSE(has("guide.page.window")) << "the hits are in the place of the pages";
  const auto hits = search_guide(*viewer_->state().guide.guide, "probe radius");
  ASSERT_GE(hits.size(), 2u);
  EXPECT_EQ(has("guide.hit." + std::to_string(hits.size())), true);
  EXPECT_FALSE(has("guide.hit." + std::to_string(hits.size() + 1)));
  const auto last = std::to_string(hits.size());
  run("click guide.hit." + last + "\nframes 3\n");
  const GuidePage& page = viewer_->state().guide.guide->pages[hits.back().place.page];
  EXPECT_TRUE(has("guide.title." + page.name())) << page.name();
  const std::string marked = "guide.marked." + std::to_string(hits.back().place.block);
  ASSERT_TRUE(has(marked));
  EXPECT_TRUE(viewer_->widgets().at(marked).visible);
  run("click guide.clear\nframes 2\n");
  EXPECT_TRUE(has("guide.page.window"));
  EXPECT_FALSE(has(marked));
}

TEST_F(GuideWindow, EnterGoesFromHitToHit) {
  open_guide();
  const auto hits = search_guide(*viewer_->state().guide.guide, "undo");
  ASSERT_GE(hits.size(), 3u);
  const auto page_of = [&](std::size_t n) {
    return "guide.title." + viewer_->state().guide.guide->pages[hits[n].place.page].name();
  };
  run("type undo\nframes 2\nkey enter\nframes 3\n");
  EXPECT_TRUE(has(page_of(0)));
  run("key enter\nframes 3\nkey enter\nframes 3\n");
  EXPECT_TRUE(has(page_of(2)));
  EXPECT_TRUE(has("guide.marked." + std::to_string(hits[2].place.block)));
  run("key up\nframes 3\nkey up\nframes 3\nkey up\nframes 3\n");
  EXPECT_TRUE(has(page_of(hits.size() - 1))) << "around the end";
  run("click guide.search\ntype zzz\nframes 2\n");
  EXPECT_TRUE(has("guide.no_hit"));
}

TEST_F(GuideWindow, LinksLeadToPagesAndBack) {
  run("help.guide\nwait-idle\nframes 4\nclick guide.link.cavities.md*\nframes 3\n");
  EXPECT_TRUE(has("guide.title.cavities"));
  run("click guide.back\nframes 3\n");
  EXPECT_TRUE(has("guide.title.README"));
  run("help.guide window#undo\nframes 3\n");
  EXPECT_TRUE(has("guide.title.window"));
  EXPECT_LT(top_of_text(), -500) << "it is scrolled to the heading";
  run("help.guide nowhere\nframes 3\n");
  EXPECT_NE(viewer_->state().notice.text().find("no page \"nowhere\""), std::string::npos);
}

TEST_F(GuideWindow, TakesTheKeysOfAReaderOnly) {
  open_crambin();
  run("help.guide window\nwait-idle\nframes 4\n");
  const double alpha = viewer_->state().settings.request.alpha_angstrom2;
  const float top = top_of_text();
  run("key pagedown\nframes 2\n");
  const float below = top_of_text();
  EXPECT_LT(below, top - 200);
  run("click guide.title.window\nkey down\nframes 2\nkey right\nframes 2\n");
  EXPECT_LT(top_of_text(), below);
  EXPECT_EQ(viewer_->state().settings.request.alpha_angstrom2, alpha);
  run("key home\nframes 2\n");
  EXPECT_EQ(top_of_text(), top);
  run("key end\nframes 2\n");
  EXPECT_LT(top_of_text(), -5000);
  run("select.atoms chain A\nframes 2\nkey esc\nframes 2\n");
  EXPECT_FALSE(viewer_->state().guide.shown);
  EXPECT_FALSE(viewer_->state().settings.selection.empty()) << "Escape closed the guide only";
  run("key right\nframes 2\n");
  EXPECT_GT(viewer_->state().settings.request.alpha_angstrom2, alpha);
}

TEST_F(GuideWindow, CopiesABlock) {
  run("help.guide\nwait-idle\nframes 4\n");
  const WidgetRect text = viewer_->widgets().at("guide.title.README");
  // The first paragraph is below the heading, whose height depends on the font only.
  const double down = 62 / static_cast<double>(text.y1 - text.y0);
  run("right-click guide.title.README 0.5 " + std::to_string(down) +
      "\nframes 2\nclick guide.copy.block\nframes 2\n");
  EXPECT_EQ(std::string(ImGui::GetClipboardText()),
            "The pages follow the order in which people need them. Each page can be read alone.");
  run("help.guide command-line\nframes 3\nclick guide.copy_code.*\nframes 2\n");
  EXPECT_EQ(std::string(ImGui::GetClipboardText()).substr(0, 19), "alphascope-cli info");
}

TEST(GuidePages, AreDrawnInAnySize) {
  const auto guide = std::make_shared<const Guide>(load_guide(docs_folder()));
  for (const Size size : {Size{500, 300, 1}, Size{1280, 800, 1}, Size{1280, 800, 2}}) {
    Panels panels(size);
    panels.state.guide.guide = guide;
    for (const GuidePage& page : guide->pages) {
      ASSERT_TRUE(panels.commands.run("help.guide", {page.name()}).done());
      panels.frame(3);
      EXPECT_TRUE(panels.rects.contains("guide.title." + page.name())) << size.width;
      const float top = panels.rects["guide.text"].y0, end = panels.rects["guide.text"].y1;
      EXPECT_GT(end - top, 600 * size.scale) << page.name();
      panels.tap(key::kEnd);
      EXPECT_LT(panels.rects["guide.text"].y0, top) << page.name();
    }
  }
}

TEST(GuideFiles, AreFoundAndOtherwiseTheirPlaceIsTold) {
  const auto read = [](const fs::path& docs) {
    GuideReader reader({}, docs);
    GuideState state;
    state.shown = true;
    do {
      reader.poll(state);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } while (reader.busy());
    return state;
  };
  const GuideState found = read(docs_folder());
  EXPECT_EQ(found.problem, "");
  ASSERT_TRUE(found.guide);
  EXPECT_GT(found.guide->pages.size(), 10u);

  const GuideState missing = read("/nowhere/docs");
  EXPECT_FALSE(missing.guide);
  EXPECT_NE(missing.problem.find("/nowhere/docs/guide/README.md"), std::string::npos);
  EXPECT_NE(missing.problem.find("alphascope-data"), std::string::npos) << missing.problem;

  Panels panels({900, 600, 1});
  panels.state.guide = missing;
  panels.frame(3);
  EXPECT_TRUE(panels.rects.contains("guide.problem"));
}

// Pieces of a text in lines of a width in pixels, with "|" between lines.
std::string lines_of(const Panels&, std::vector<FlowSpan> spans, float width) {
  const ImFont* const font = ImGui::GetIO().Fonts->Fonts[0];
  for (FlowSpan& span : spans) span.font = font;
  std::string lines;
  float y = 0, right = 0;
  const FlowArea area{{10, 0}, width, 20, font};
  const float height = flow_text(spans, area, [&](const FlowPiece& piece) {
    if (!lines.empty()) lines += piece.low.y > y ? "|" : piece.low.x > right + 1 ? " " : "";
    lines += piece.text;
    EXPECT_GE(piece.low.x, 10);
    EXPECT_LE(piece.high.x, 10 + width + 0.5f) << piece.text;
    y = piece.low.y;
    right = piece.high.x;
  });
  EXPECT_EQ(height, 20.0f * static_cast<float>(std::count(lines.begin(), lines.end(), '|') + 1));
  return lines;
}

TEST(FlowingText, BreaksAtBlanksOnly) {
  const Panels panels({300, 300, 1});
  EXPECT_EQ(lines_of(panels, {{"one two "}, {"three"}, {", four"}}, 1000), "one two three, four");
  const auto width = [](const char* text) {
    const ImFont* const font = ImGui::GetIO().Fonts->Fonts[0];
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text).x + 0.1f;
  };
  EXPECT_EQ(lines_of(panels, {{"one two "}, {"three"}, {", four"}}, width("three, four")),
            "one two|three, four");
  EXPECT_EQ(lines_of(panels, {{"to "}, {"three"}, {", four"}}, width("to three")), "to|three,|four")
      << "the comma stays with its word, although it is in another span";
  EXPECT_EQ(lines_of(panels, {{"of 12 Å, or"}}, width("of 12 ")), "of|12 Å,|or");
  EXPECT_EQ(lines_of(panels, {{"a\nb"}}, 100), "a|b");
  EXPECT_EQ(lines_of(panels, {{"abcdefghij"}}, width("abcd")), "abcd|efgh|ij");
  EXPECT_TRUE(lines_of(panels, {{"ab/cdefghij"}}, width("ab/cde")).starts_with("ab/|cde"));
}

// The font is one in which each byte is one pixel wide.
TEST(FittedBeginning, CutsBetweenCharacters) {
  const auto width = [](const std::string& text) { return static_cast<float>(text.size()); };
  EXPECT_EQ(fitted_beginning("aÅÅb", 6, width), "aÅÅb");
  EXPECT_EQ(fitted_beginning("aÅÅbc", 6, width), "aÅ…");
  EXPECT_EQ(fitted_beginning("aÅÅbc", 5, width), "a…");
  EXPECT_EQ(fitted_beginning("abc", 2, width), "…");
}

}  // namespace
}  // namespace alphascope::testing
