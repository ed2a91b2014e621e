// SPDX-License-Identifier: GPL-3.0-or-later
// Tests common properties of dialogs that write a file: the path that they offer, Browse, and that
// nothing in them moves.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/document/store/inputs.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/panel.hpp"

namespace alphascope::testing {
namespace {

namespace fs = std::filesystem;

class SaveDialogs : public ::testing::Test {
 protected:
  SaveDialogs()
      : folder_(fs::temp_directory_path() / ("alphascope_save_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "inside");
    p.state = loaded_state();
    p.state.molecule.folder = folder_.string();
    p.frame(3);
  }
  ~SaveDialogs() override { fs::remove_all(folder_); }
  ViewState& state() { return p.state; }
  std::string path(const std::string& name) { return (folder_ / name).string(); }
  void list() {
    p.frame(2);
    if (const auto wanted = wanted_listing(state().browser)) {
      p.state.listing = std::make_shared<const FolderListing>(list_folder(*wanted));
    }
    p.frame(3);
  }
  // Opens each dialog, calls `look` with its name, and cancels it.
  void in_each(
      const std::function<void(const std::string& dialog, const std::string& path)>& look) {
    const struct {
      const char* dialog;
      std::function<void()> open;
      std::function<std::string()> path;
    } all[] = {{"save", [&] { state().dialogs.show_save = true; },
                [&] { return state().dialogs.save_path; }},
               {"export", [&] { state().dialogs.show_export = true; },
                [&] { return state().dialogs.export_path; }},
               {"record", [&] { state().record.show = true; }, [&] { return state().record.path; }},
               {"save_session", [&] { state().dialogs.show_save_session = true; },
                [&] { return state().dialogs.session_path; }},
               {"save_table",
                [&] {
                  TableToSave table{.what = "Cavities",
                                    .file_name = "4hhb-cavities",
                                    .csv = Definition<std::string>(
                                        {.id = "test.table", .title = "A table"},
                                        [](const Inputs&, const RunContext&) {
                                          return std::make_shared<const std::string>("x");
                                        })};
                  state().save_table.path.clear();
                  state().save_table.table = std::make_shared<const TableToSave>(table);
                },
                [&] { return state().save_table.path; }}};
    for (const auto& one : all) {
      one.open();
      p.frame(4);
      look(one.dialog, one.path());
      p.click(std::string(one.dialog) + ".cancel");
      p.frame(3);
    }
  }

  Panels p{{1280, 800, 1}};
  fs::path folder_;
};

TEST_F(SaveDialogs, OfferTheMoleculesFolderAndName) {
  std::map<std::string, std::string> offered;
  in_each([&](const std::string& dialog, const std::string& path) { offered[dialog] = path; });
  EXPECT_EQ(offered["save"], path("4hhb.png"));
  EXPECT_EQ(offered["export"], path("4hhb.glb"));
  EXPECT_EQ(offered["record"], path("4hhb-%04d.png"));
  EXPECT_EQ(offered["save_session"], path("4hhb.json"));
  EXPECT_EQ(offered["save_table"], path("4hhb-cavities.csv"));
}

TEST_F(SaveDialogs, OfferTheFolderOfTheFileThatWasWrittenLastAndTheNameTypedLast) {
  state().dialogs.show_save = true;
  state().dialogs.save_path = path("inside/mine.png");
  p.frame(4);
  p.click("save.ok");
  p.frame(3);
  in_each([&](const std::string& dialog, const std::string& offered) {
    EXPECT_EQ(fs::path(offered).parent_path(), folder_) << dialog << ": nothing was written yet";
  });
  state().saving.folder = folder_ / "inside";
  in_each([&](const std::string& dialog, const std::string& offered) {
    EXPECT_EQ(fs::path(offered).parent_path(), folder_ / "inside") << dialog;
    if (dialog == "save") {
      EXPECT_EQ(fs::path(offered).filename(), "mine.png");
    }
  });
}

TEST_F(SaveDialogs, OfferNoFolderOfSamples) {
  p.state.samples = {{"crambin", "1CRN", folder_ / "1crn.pdb"}};
  in_each([&](const std::string& dialog, const std::string& offered) {
    EXPECT_EQ(fs::path(offered).parent_path(), fs::current_path()) << dialog;
  });
}

// A name with another format's ending is refused. It gets no second ending.
TEST_F(SaveDialogs, AnotherEndingIsRefused) {
  const struct {
    std::string dialog, wrong, right, written;
  } cases[] = {{"save", "a.jpg", "a", "a.png"},
               {"save", "a.PDB", "a_1.4", "a_1.4.png"},
               {"save_session", "a.txt", "a", "a.json"}};
  for (const auto& c : cases) {
    const bool picture = c.dialog == "save";
    (picture ? state().dialogs.show_save : state().dialogs.show_save_session) = true;
    std::string& typed = picture ? state().dialogs.save_path : state().dialogs.session_path;
    typed = path(c.wrong);
    p.frame(4);
    EXPECT_TRUE(p.rects.contains(c.dialog + ".ending")) << c.wrong;
    p.click(c.dialog + ".ok");
    p.frame(3);
    EXPECT_TRUE(picture ? state().dialogs.show_save : state().dialogs.show_save_session)
        << "it cannot be saved";
    typed = path(c.right);
    p.frame(3);
    EXPECT_FALSE(p.rects.contains(c.dialog + ".ending")) << c.right;
    p.click(c.dialog + ".ok");
    const fs::path wanted = picture ? p.asked.screenshot->path : *p.asked.save_session;
    EXPECT_EQ(wanted, path(c.written));
    p.asked.screenshot.reset();
    p.asked.save_session.reset();
    p.frame(3);
  }
}

TEST_F(SaveDialogs, AnEmptyFieldStaysEmpty) {
  state().dialogs.show_export = true;
  p.frame(4);
  p.type("export.path", " ");
  state().dialogs.export_path.clear();
  p.frame(3);
  EXPECT_EQ(state().dialogs.export_path, "");
  EXPECT_TRUE(state().dialogs.show_export);
}

TEST_F(SaveDialogs, BrowseChoosesAFolderAndKeepsTheName) {
  in_each([&](const std::string& dialog, const std::string& offered) {
    const std::string name = fs::path(offered).filename().string();
    const fs::path before = state().browser.folder;
    p.click(dialog + ".browse");
    list();
    ASSERT_TRUE(p.rects.contains("browser.entry.inside")) << dialog;
    p.tap(key::kDown);
    p.tap(key::kEnter);
    list();
    EXPECT_EQ(state().browser.folder, folder_ / "inside") << dialog;
    p.tap(key::kEnter);  // the file to be saved
    p.frame(4);
    EXPECT_FALSE(state().browser.show) << dialog;
    EXPECT_EQ(state().browser.folder, before) << "Open stays where it was";
    const std::string now = dialog == "save"           ? state().dialogs.save_path
                            : dialog == "export"       ? state().dialogs.export_path
                            : dialog == "record"       ? state().record.path
                            : dialog == "save_session" ? state().dialogs.session_path
                                                       : state().save_table.path;
    EXPECT_EQ(now, path("inside/" + name)) << dialog;
  });
}

TEST_F(SaveDialogs, BrowseTakesTheNameOfAFileAndCancelLeavesAll) {
  std::ofstream(folder_ / "old.stl") << "x";
  state().dialogs.show_export = true;
  p.frame(4);
  p.click("export.browse");
  list();
  p.click("browser.entry.old.stl");
  p.click("browser.open");
  p.frame(4);
  EXPECT_EQ(state().dialogs.export_path, path("old.stl"));
  EXPECT_TRUE(p.rects.contains("export.replaces"));
  p.click("export.browse");
  list();
  p.click("browser.cancel");
  p.frame(4);
  EXPECT_EQ(state().dialogs.export_path, path("old.stl"));
}

// Tries every choice in the dialog, with paths that can be written and others.
TEST_F(SaveDialogs, NothingJumps) {
  state().record.show = true;
  p.frame(4);
  const float y = p.rects["record.ok"].y0, x = p.rects["record.ok"].x0;
  const auto same = [&](const char* when) {
    p.frame(4);
    EXPECT_EQ(p.rects["record.ok"].y0, y) << when;
    EXPECT_EQ(p.rects["record.ok"].x0, x) << when;
  };
  for (const char* widget : {"record.kind.1", "record.kind.2", "record.kind.0", "record.format.1",
                             "record.format.2", "record.format.0", "record.caption"}) {
    p.click(widget);
    same(widget);
  }
  state().record.path = "/no/such/folder/x.docx";
  same("a path that cannot be");
  p.click("record.cancel");
  p.frame(3);
  state().dialogs.show_save = true;
  p.frame(4);
  const float save_y = p.rects["save.ok"].y0;
  p.click("save.caption");
  p.frame(4);
  EXPECT_EQ(p.rects["save.ok"].y0, save_y);
}

}  // namespace
}  // namespace alphascope::testing
