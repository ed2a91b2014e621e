// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the pages of the guide, their links and the search, with pages of its own and with those of
// the program.
#include "core/document/guide/guide.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/files/read_error.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

class GuideTest : public ::testing::Test {
 protected:
  GuideTest()
      : docs_(fs::temp_directory_path() / ("alphascope_guide_" + std::to_string(getpid()))) {
    fs::create_directories(docs_ / "guide");
    write("guide/README.md",
          "# Guide\n\n| page | read it to |\n|---|---|\n| [Second](b.md) | see *b* |\n"
          "| [First](a.md) | see a |\n\nAlso [files](../files.md), [again](a.md#x), "
          "[out](https://a.org/x.md).\n");
    write("guide/a.md",
          "# Page A\n\nAlpha is a number.\n\n## The *Undo* key\n\nBetalpha, alphas.\n");
    write("guide/b.md", "# Page B\n\nSee [undo](a.md#the-undo-key).\n");
    write("files.md", "# Files of molecules\n\nThe ALPHA value of `--alpha`.\n");
  }
  ~GuideTest() override { fs::remove_all(docs_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(docs_ / name) << text;
  }

  fs::path docs_;
};

TEST_F(GuideTest, HasThePagesOfItsListInTheirOrder) {
  const Guide guide = load_guide(docs_);
  std::vector<std::string> titles, files;
  for (const GuidePage& page : guide.pages) {
    titles.push_back(page.title);
    files.push_back(page.file);
    EXPECT_EQ(page.problem, "");
  }
  ASSERT_EQ(titles, (std::vector<std::string>{"Guide", "Second", "First", "Files of molecules"}));
  EXPECT_EQ(files,
            (std::vector<std::string>{"guide/README.md", "guide/b.md", "guide/a.md", "files.md"}));
  EXPECT_EQ(guide.pages[1].summary, "see b");
  EXPECT_EQ(guide.pages[1].name(), "b");
}

TEST_F(GuideTest, FollowsLinks) {
  const Guide guide = load_guide(docs_);
  EXPECT_EQ(follow_link(guide, 1, "a.md#the-undo-key"), (GuidePlace{2, 2}));
  EXPECT_EQ(follow_link(guide, 3, "guide/a.md"), (GuidePlace{2, 0}));
  EXPECT_EQ(follow_link(guide, 2, "#the-undo-key"), (GuidePlace{2, 2}));
  EXPECT_EQ(follow_link(guide, 2, "#nowhere"), (GuidePlace{2, 0}));
  EXPECT_EQ(follow_link(guide, 0, "https://a.org/x.md"), std::nullopt);
  EXPECT_EQ(follow_link(guide, 0, "../images/a.png"), std::nullopt);
  EXPECT_EQ(follow_link(guide, 0, "c.md"), std::nullopt);
  EXPECT_EQ(find_page(guide, "A#the-undo-key"), (GuidePlace{2, 2}));
  EXPECT_EQ(find_page(guide, "second"), (GuidePlace{1, 0}));
  EXPECT_EQ(find_page(guide, "files.md"), (GuidePlace{3, 0}));
  EXPECT_EQ(find_page(guide, "third"), std::nullopt);
}

TEST_F(GuideTest, FindsBeginningsOfWordsInAnyCase) {
  const Guide guide = load_guide(docs_);
  const std::vector<GuideHit> hits = search_guide(guide, "ALPHA");
  ASSERT_EQ(hits.size(), 3u);
  EXPECT_EQ(hits[0].place, (GuidePlace{2, 1}));
  EXPECT_EQ(hits[0].heading, "Page A");
  EXPECT_EQ(hits[0].excerpt, "Alpha is a number.");
  EXPECT_EQ(hits[1].place, (GuidePlace{2, 3}));
  EXPECT_EQ(hits[1].heading, "The Undo key");
  EXPECT_EQ(hits[2].place, (GuidePlace{3, 1}));
  EXPECT_EQ(search_guide(guide, "alpha value").size(), 1u);
  EXPECT_EQ(search_guide(guide, "--alp").size(), 1u);
  EXPECT_EQ(search_guide(guide, "lpha").size(), 0u);
  EXPECT_EQ(search_guide(guide, " ").size(), 0u);
  EXPECT_EQ(find_word("Betalpha, alphas.", {"alpha"}, 0),
            (std::pair<std::size_t, std::size_t>{10, 5}));
}

TEST_F(GuideTest, ShowsTheTextAroundAHit) {
  write("guide/b.md",
        "# B\n\n" + std::string(40, 'x') + " one two needle " + std::string(300, 'y') + "\n");
  const std::vector<GuideHit> hits = search_guide(load_guide(docs_), "needle");
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_TRUE(hits[0].excerpt.starts_with("…one two needle yyy")) << hits[0].excerpt;
  EXPECT_TRUE(hits[0].excerpt.ends_with("yyy…"));
  EXPECT_LT(hits[0].excerpt.size(), 200u);
}

TEST_F(GuideTest, TellsWhichPageIsMissing) {
  fs::remove(docs_ / "guide/a.md");
  const Guide guide = load_guide(docs_);
  ASSERT_EQ(guide.pages.size(), 4u);
  EXPECT_NE(guide.pages[2].problem.find("guide/a.md"), std::string::npos);
  fs::remove(docs_ / "guide/README.md");
  EXPECT_THROW(load_guide(docs_), ReadError);
}

// Every link of the real pages to another page of the guide leads to a heading or to a page.
TEST(GuideOfTheProgram, HasPagesAndNoBrokenMarks) {
  const Guide guide = load_guide(fs::path(ALPHASCOPE_SOURCE_DIR) / "docs");
  EXPECT_GE(guide.pages.size(), 15u);
  std::size_t anchors = 0;
  for (std::size_t p = 0; p < guide.pages.size(); ++p) {
    EXPECT_EQ(guide.pages[p].problem, "");
    EXPECT_GT(guide.pages[p].blocks.size(), 5u) << guide.pages[p].file;
    for (const MarkdownBlock& block : guide.pages[p].blocks) {
      for (const MarkdownText& text : block.cells) {
        for (const MarkdownSpan& span : text) {
          const bool marks = span.text.find("**") != std::string::npos ||
                             span.text.find("](") != std::string::npos;
          EXPECT_TRUE(span.code || !marks) << span.text;
          if (span.link.find('#') == std::string::npos) continue;
          const auto place = follow_link(guide, p, span.link);
          if (!place) continue;  // to a page outside of the guide
          EXPECT_GT(place->block, 0u) << guide.pages[p].file << " " << span.link;
          ++anchors;
        }
      }
    }
  }
  EXPECT_GT(anchors, 30u);
}

}  // namespace
}  // namespace alphascope
