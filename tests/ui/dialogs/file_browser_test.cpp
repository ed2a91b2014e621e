// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the file dialog: keys, typed paths, and its messages. There is no renderer and no worker.
// The test lists folders itself; in the program another thread does so.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/panels/panel.hpp"

namespace alphascope::testing {
namespace {

namespace fs = std::filesystem;

class FileBrowser : public ::testing::Test {
 protected:
  FileBrowser()
      : folder_(fs::temp_directory_path() / ("alphascope_browser_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "inside");
    std::ofstream(folder_ / "inside" / "deep.pdb") << "x";
    for (int i = 0; i < 200; ++i) {
      std::ofstream(folder_ / ("m" + std::to_string(100 + i) + ".pdb")) << "x";
    }
    std::ofstream(folder_ / "zebra.pdb") << std::string(1'200'000, 'x');
    state().browser.folder = folder_;
    state().browser.show = true;
    list();
  }
  ~FileBrowser() override { fs::remove_all(folder_); }

  ViewState& state() { return p.state; }
  std::string selected() { return state().browser.selected.filename().string(); }
  void list() {
    p.frame(2);
    if (const auto wanted = wanted_listing(state().browser)) {
      p.state.listing = std::make_shared<const FolderListing>(list_folder(*wanted));
    }
    p.frame(3);
  }
  void letters(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    p.frame(2);
  }

  Panels p{{1280, 800, 1}};
  fs::path folder_;
};

TEST_F(FileBrowser, ShowsRowsInSightOnly) {
  std::size_t rows = 0;
  for (const auto& [name, rect] : p.rects) rows += name.starts_with("browser.entry.");
  EXPECT_GT(rows, 5u);
  EXPECT_LT(rows, 40u) << "of 202";
}

TEST_F(FileBrowser, ArrowKeysChooseAndEnterOpens) {
  p.tap(key::kDown);
  EXPECT_EQ(selected(), "inside");
  p.tap(key::kDown);
  p.tap(key::kDown);
  EXPECT_EQ(selected(), "m101.pdb");
  p.tap(key::kUp);
  EXPECT_EQ(selected(), "m100.pdb");
  p.tap(key::kEnter);
  EXPECT_EQ(*p.asked.open, folder_ / "m100.pdb");
  EXPECT_FALSE(state().browser.show);
}

TEST_F(FileBrowser, KeysAreNotForItWhileADialogIsAbove) {
  p.tap(key::kDown);
  p.tap(key::kDown);
  p.tap(key::kF1);
  p.frame(3);
  p.tap(key::kDown);
  p.tap(key::kEnter);
  p.frame(2);
  EXPECT_FALSE(state().dialogs.show_cheat_sheet);
  EXPECT_EQ(selected(), "m100.pdb");
  EXPECT_FALSE(p.asked.open);
  EXPECT_TRUE(state().browser.show);
}

TEST_F(FileBrowser, HomeEndAndPagesScrollWhatTheyChooseIntoSight) {
  p.tap(key::kEnd);
  EXPECT_EQ(selected(), "zebra.pdb");
  p.frame(2);
  ASSERT_TRUE(p.rects.contains("browser.entry.zebra.pdb"));
  EXPECT_TRUE(p.rects["browser.entry.zebra.pdb"].visible);
  p.tap(key::kPageUp);
  const std::string page = selected();
  EXPECT_GT(page, "m270.pdb");
  EXPECT_LT(page, "m299.pdb");
  p.tap(key::kPageDown);
  EXPECT_EQ(selected(), "zebra.pdb");
  p.tap(key::kHome);
  p.frame(2);
  EXPECT_EQ(selected(), "inside");
  EXPECT_TRUE(p.rects.contains("browser.entry.inside"));
}

TEST_F(FileBrowser, LettersJumpToAName) {
  letters("z");
  EXPECT_EQ(selected(), "zebra.pdb");
  state().browser.jump_seconds -= 10;  // a pause
  letters("m15");
  EXPECT_EQ(selected(), "m150.pdb");
  letters("7");
  EXPECT_EQ(selected(), "m157.pdb");
}

TEST_F(FileBrowser, FoldersAreEnteredAndLeftWithTheKeyboard) {
  p.tap(key::kHome);
  p.tap(key::kEnter);
  EXPECT_EQ(state().browser.folder, folder_ / "inside");
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("browser.reading")) << "the old folder's rows are gone at once";
  list();
  EXPECT_TRUE(p.rects.contains("browser.entry.deep.pdb"));
  p.tap(key::kBackspace);
  EXPECT_EQ(state().browser.folder, folder_);
  EXPECT_EQ(selected(), "inside") << "where one comes from";
}

TEST_F(FileBrowser, AWrongPathStaysAndSaysWhy) {
  const float y = p.rects["browser.open"].y0;
  p.type("browser.path", (folder_ / "no.pdb").string());
  EXPECT_TRUE(state().browser.show);
  EXPECT_FALSE(p.asked.open);
  EXPECT_NE(state().browser.error.find("no.pdb"), std::string::npos);
  EXPECT_TRUE(p.rects.contains("browser.error"));
  EXPECT_EQ(p.rects["browser.open"].y0, y) << "nothing moves";
  p.type("browser.path", "zebra.pdb");  // in the folder that is shown
  EXPECT_FALSE(state().browser.show);
  EXPECT_EQ(*p.asked.open, folder_ / "zebra.pdb");
}

}  // namespace
}  // namespace alphascope::testing
