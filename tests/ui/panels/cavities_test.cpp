// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page of cavities in the whole window: the table, CASTp's choices, a cavity in the
// picture.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_identity.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "tests/support/grid_of_balls.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/panels/cavities/cavity_page.hpp"

namespace alphascope::testing {
namespace {

class CavitiesTest : public ViewerTest {
 protected:
  void open_cavities() {
    run("open " ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz\nwait-idle\n");
    run("click bottom.cavities\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  }
  void use_preset() { run("click cavities.preset\nwait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  const CavityPage& page() { return *viewer_->state().cavities.page; }
  std::string text(const char* column, std::size_t row) {
    return cavity_text(page().rows, column, row);
  }
  std::string name(std::size_t row) {
    return cavity_name(*page().rows.lines->atoms, page().rows.table(), row);
  }
  // After a click, results may come one after the other.
  void settle() { run("wait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  void shift_click(const std::string& widget) {
    const WidgetRect at = viewer_->widgets().at(widget);
    ScriptedInput input;
    input.x = at.x0 + 60;
    input.y = (at.y0 + at.y1) / 2;
    input.shift = true;
    for (const bool down : {false, true, false, false}) {
      input.down[0] = down;
      viewer_->step(&input);
    }
  }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
  void save(const fs::path& path) {
    run("click cavities.save\nframes 3\n");
    viewer_->state().save_table.path = path.string();
    run("frames 2\nclick save_table.ok\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  }
};

TEST_F(CavitiesTest, ThePresetComparesWithCastpAndCanBeUndone) {
  open_cavities();
  ASSERT_TRUE(has("cavities.row.1"));
  ASSERT_TRUE(has("cavities.preset")) << "radii, ligands and solvent radius are others";
  const std::size_t before = page().rows.size();
  use_preset();
  EXPECT_FALSE(has("cavities.preset"));
  EXPECT_EQ(viewer_->state().result->request.solvent_radius_angstrom, 1.4);
  EXPECT_EQ(viewer_->state().references->prepared().report.radii, RadiiSet::castp);
  EXPECT_EQ(page().rows.table().voids, 47u);
  EXPECT_EQ(page().rows.table().pockets, 39u);
  EXPECT_NE(page().rows.size(), before);
  // A line for each cavity, with the exact volume once it is known.
  ASSERT_EQ(page().rows.size(), 86u);
  EXPECT_NEAR(page().rows.lines->of[0].volume_sa_angstrom3, 3989.080, 0.001);
  EXPECT_EQ(text("volume_sa_clipped_angstrom3", 0), "3,992.08  ");
  EXPECT_EQ(text("depth_angstrom", 3), "12.84");
  EXPECT_EQ(name(3), "A:PHE 43:CZ A:HIS 87:NE2 A:VAL 93:CG2 A:LEU 101:CD2");
  run("edit.undo\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_TRUE(has("cavities.preset"));
  EXPECT_EQ(page().rows.size(), before);
}

// The first search has no older rows to show.
TEST_F(CavitiesTest, ThePageSaysThatTheFirstSearchWasCancelled) {
  run("view.page timings\nopen " ALPHASCOPE_SOURCE_DIR
      "/resources/molecules/4hhb.pdb.gz\nwait-idle\nview.page cavities\n");
  for (int k = 0; k < 2000 && !has("cavities.cancelled"); ++k) {
    viewer_->calls().jobs.cancel_result("cavities.table");
    run("frames 1\n");
  }
  ASSERT_TRUE(has("cavities.cancelled"));
  EXPECT_FALSE(has("cavities.totals") || has("cavities.waiting"));
  run("click cavities.again\n");
  settle();
  EXPECT_FALSE(has("cavities.cancelled"));
  EXPECT_TRUE(has("cavities.row.1"));
}

// "21 of 0 shown" was the text without a cavity.
TEST_F(CavitiesTest, ATableWithoutRowsShowsNoneOfThem) {
  open_crambin();
  run("view.page cavities\n");
  settle();
  ASSERT_FALSE(page().order.empty());
  run("alpha.set 900\n");
  settle();
  ASSERT_TRUE(has("cavities.empty"));
  EXPECT_EQ(page().rows.size(), 0u);
  EXPECT_TRUE(page().order.empty());
}

TEST_F(CavitiesTest, AClickShowsTheCavityAndWhatLinesIt) {
  open_cavities();
  use_preset();
  const Image plain = picture();
  run("click cavities.row.4 0.2\nwait-idle\nframes 5\n");
  ASSERT_EQ(viewer_->state().layers.size(), 4u)
      << "surface, rims of its mouths, what lines it, what it holds";
  const Layer& body = *viewer_->state().layers[0];
  EXPECT_TRUE(body.body);
  // The boundary of tetrahedra is closed, so each edge has an even number of triangles.
  std::map<std::pair<BallIndex, BallIndex>, int> edges;
  for (const auto& t : body.triangles) {
    ++edges[{t[0], t[1]}];
    ++edges[{t[0], t[2]}];
    ++edges[{t[1], t[2]}];
  }
  EXPECT_FALSE(edges.empty());
  for (const auto& [edge, count] : edges) EXPECT_EQ(count % 2, 0);
  EXPECT_FALSE(viewer_->state().layers[1]->edges.empty());
  EXPECT_NE(picture().rgba, plain.rgba);
  ASSERT_FALSE(page().drawn->residues.empty());
  EXPECT_EQ(page().drawn->residues[0].chain, "A");
  EXPECT_NE(page().drawn->residues[0].residues.find("HIS 87"), std::string::npos);
  EXPECT_GT(viewer_->state().settings.selection.items.size(), 20u);
  // The cavity stays chosen while alpha moves, because its deepest sink identifies it.
  const RefSet chosen = viewer_->state().settings.selection.cavities;
  EXPECT_EQ(chosen.size(), 1u);
  run("alpha.set 0.1\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  ASSERT_EQ(page().rows.table().question.alpha_angstrom2, 0.1);
  EXPECT_EQ(viewer_->state().settings.selection.cavities, chosen);
  EXPECT_EQ(page().selected_rows.size(), 1u);
  EXPECT_EQ(viewer_->state().layers.size(), 4u);
}

TEST_F(CavitiesTest, ACommandChoosesACavityBeforeTheTableIsThere) {
  run("open " ALPHASCOPE_SOURCE_DIR
      "/resources/molecules/4hhb.pdb.gz\nview.page timings\nwait-idle\n");
  run("cavities.choose 2\n");
  EXPECT_TRUE(viewer_->state().settings.selection.cavities.empty()) << "the table is not there yet";
  settle();
  EXPECT_EQ(page().selected_rows, std::vector<std::size_t>{1});
  EXPECT_EQ(viewer_->state().settings.selection.cavities.size(), 1u);
  EXPECT_FALSE(viewer_->state().layers.empty());
  const std::size_t rows = page().rows.size();
  run("cavities.choose 1000000\n");
  settle();
  EXPECT_EQ(viewer_->state().notice.text(),
            "There is no cavity 1,000,000; the last is " + std::to_string(rows) + ".");
  EXPECT_EQ(page().selected_rows, std::vector<std::size_t>{1});
}

TEST_F(CavitiesTest, UndoTakesCavityAndSelectionBackTogether) {
  open_cavities();
  run("click cavities.row.2 0.2\nwait-idle\nframes 3\n");
  const RefSet second = viewer_->state().settings.selection.cavities;
  const RefSet lining = viewer_->state().settings.selection.items;
  run("click cavities.row.5 0.2\nwait-idle\nframes 3\n");
  EXPECT_NE(viewer_->state().settings.selection.cavities, second);
  run("edit.undo\nwait-idle\nframes 3\n");
  EXPECT_EQ(viewer_->state().settings.selection.cavities, second);
  EXPECT_EQ(viewer_->state().settings.selection.items, lining);
  EXPECT_EQ(page().selected_rows, std::vector<std::size_t>{1});
  EXPECT_EQ(viewer_->state().notice.text(), "Undone: selection");
  run("edit.undo\nwait-idle\nframes 3\n");
  EXPECT_TRUE(viewer_->state().settings.selection.empty());
  EXPECT_TRUE(viewer_->state().layers.empty());
}

TEST_F(CavitiesTest, SeveralAreChosenByKeysAndButtons) {
  open_cavities();
  run("click cavities.row.2 0.2\nframes 3\n");
  shift_click("cavities.row.5");
  EXPECT_EQ(page().selected_rows, (std::vector<std::size_t>{1, 2, 3, 4}));
  run("click cavities.kind.1\nframes 3\nclick cavities.all\n");
  settle();
  EXPECT_EQ(page().selected_rows.size(), page().rows.table().voids);
  for (const std::size_t row : page().selected_rows) {
    EXPECT_TRUE(page().rows.lines->of[row].is_void);
  }
  EXPECT_EQ(page().drawn->of.size(), page().selected_rows.size());
  run("click cavities.none\nframes 3\n");
  EXPECT_TRUE(viewer_->state().settings.selection.empty());
}

TEST_F(CavitiesTest, WhatIsTypedAsLeastVolumeIsChecked) {
  open_cavities();
  use_preset();
  run("click cavities.least\nkey ctrl+a\ntype 30 Å3\nkey enter\nframes 3\n");
  EXPECT_EQ(page().filter.least_volume_angstrom3, 30);
  EXPECT_EQ(page().order.size(), 9u);
  run("click cavities.least\nkey ctrl+a\ntype 1.4 A2\nkey enter\nframes 3\n");
  EXPECT_TRUE(has("cavities.least.error"));
  EXPECT_EQ(
      viewer_->state().number.refused["cavities.least"].error,
      "“1.4 A2” has another unit. The least volume is a volume, in Å³. Write a number such as "
      "1.4 Å³.");
  EXPECT_EQ(page().filter.least_volume_angstrom3, 30);
}

TEST_F(CavitiesTest, NegativeVolumesAreHiddenByNoFilterButTheirOwn) {
  CavityLine line;
  line.volume_sa_angstrom3 = -0.5;
  CavityFilter filter;
  EXPECT_TRUE(filter.shows(line));
  filter.least_volume_angstrom3 = 0.01;
  EXPECT_FALSE(filter.shows(line));
}

TEST_F(CavitiesTest, ColumnsAreChosenAndWhatTheyNeedFollows) {
  open_cavities();
  EXPECT_EQ(page().rows.lives, nullptr) << "nobody looks at it";
  run("click cavities.columns\nframes 2\nclick cavities.columns.gone_alpha_angstrom2\nkey esc\n");
  settle();
  EXPECT_TRUE(is_shown(page(), "gone_alpha_angstrom2"));
  ASSERT_NE(page().rows.lives, nullptr);
  EXPECT_NE(text("gone_alpha_angstrom2", 0), "…");
  EXPECT_GT(page().rows.life(0).gone, 0);
}

TEST_F(CavitiesTest, WithHardlyAnyProbeItOffersWater) {
  open_cavities();
  run("click cavities.water\n");
  settle();
  EXPECT_FALSE(has("cavities.giant"));
  EXPECT_EQ(viewer_->state().result->request.solvent_radius_angstrom, 1.4);
}

TEST_F(CavitiesTest, WhatIsDrawnIsAChoice) {
  open_cavities();
  run("click cavities.row.2 0.2\nframes 3\n");
  run("click cavities.draw\nframes 2\nclick cavities.draw.surfaces\nclick "
      "cavities.draw.tetrahedra\nclick cavities.draw.numbers\nclick cavities.draw.rims\n");
  settle();
  const Layers& layers = viewer_->state().layers;
  ASSERT_EQ(layers.size(), 3u) << "tetrahedra, number, what lines it";
  EXPECT_TRUE(layers[0]->triangles.empty());
  EXPECT_EQ(layers[0]->tetrahedra.size(), page().rows.table().cavity(1).tetrahedra.size());
  ASSERT_EQ(layers[1]->labels.size(), 1u);
  EXPECT_EQ(layers[1]->labels[0].text, "2");
}

TEST_F(CavitiesTest, TablesFollowWhileTheSolventRadiusSlides) {
  open_cavities();
  use_preset();
  run("click cavities.row.4 0.2\nwait-idle\nframes 3\n");
  const RefSet chosen = viewer_->state().settings.selection.cavities;
  const auto number_of = [&](std::size_t row) {
    return page().rows.lines->numbers->of[page().rows.table().order[row]];
  };
  const std::uint32_t number = number_of(page().selected_rows.at(0));
  const WidgetRect slider = viewer_->widgets().at("alpha.solvent");
  ScriptedInput input;
  input.y = (slider.y0 + slider.y1) / 2;
  const auto move_to = [&](double radius) {  // Å; the slider ends at 5
    input.x = slider.x0 + static_cast<float>(radius / 5) * (slider.x1 - slider.x0);
    viewer_->step(&input);
  };
  move_to(1.4);
  input.down[0] = true;
  std::set<const CavityLines*> tables;  // while the slider is dragged
  std::vector<std::shared_ptr<const CavityLines>> kept;
  const auto begin = std::chrono::steady_clock::now();
  for (int n = 0; tables.size() < 4; ++n) {
    ASSERT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(120));
    move_to(1.4 + 0.04 * (1 - std::cos(0.2 * n)));  // to 1.48 in 20 frames
    if (tables.insert(page().rows.lines.get()).second) kept.push_back(page().rows.lines);
    ASSERT_EQ(page().selected_rows.size(), 1u) << "it stays the same cavity";
    EXPECT_EQ(number_of(page().selected_rows[0]), number);
  }
  input.down[0] = false;
  viewer_->step(&input);
  settle();
  EXPECT_EQ(page().rows.table().question.solvent_radius_angstrom,
            viewer_->state().settings.request.solvent_radius_angstrom);
  EXPECT_EQ(viewer_->state().settings.selection.cavities, chosen);
  EXPECT_EQ(viewer_->state().undo_text, "solvent radius and selection") << "the lining follows";
}

TEST_F(CavitiesTest, ADragInRealTimeMakesTables) {
  open_cavities();
  use_preset();
  const std::uint64_t before = viewer_->times_made("cavities.lines");
  const auto begin = std::chrono::steady_clock::now();
  run("drag alpha.solvent 0.2 0.6 1.5\nwait-idle\nframes 3\n");
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(1500));
  EXPECT_GE(viewer_->times_made("cavities.lines"), before + 3);
  EXPECT_EQ(page().rows.table().question.solvent_radius_angstrom,
            viewer_->state().settings.request.solvent_radius_angstrom);
  EXPECT_EQ(viewer_->state().result->request.solvent_radius_angstrom,
            viewer_->state().settings.request.solvent_radius_angstrom);
}

TEST_F(CavitiesTest, SavedTablesAreThoseOfTheCommandLine) {
  open_cavities();
  use_preset();
  run("click cavities.least\nkey ctrl+a\ntype 30\nkey enter\nframes 3\n");
  save(folder_ / "c.csv");
  const std::string csv = bytes("c.csv");
  EXPECT_EQ(viewer_->state().notice.text(), "Saved " + (folder_ / "c.csv").string());
  const std::string file = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
  const std::string by = (folder_ / "by.csv").string();
  ASSERT_EQ(std::system((ALPHASCOPE_CLI " cavities -q '" + file + "' --min-volume 30 --csv '" + by +
                         "' > /dev/null")
                            .c_str()),
            0);
  std::string expected = bytes("by.csv");
  for (std::size_t at; (at = expected.find("alphascope-cli ")) != expected.npos;) {
    expected.replace(at, 15, "alphascope ");
  }
  EXPECT_GT(csv.size(), 1000u);
  EXPECT_EQ(csv, expected);
  run("click cavities.save\nframes 3\nclick save_table.format\nframes 2\n"
      "click save_table.json\nframes 2\n");
  EXPECT_EQ(viewer_->state().save_table.path, (folder_ / "4hhb-cavities.json").string());
  run("click save_table.ok\nwait-idle\nframes 3\n");
  const std::string json = bytes("4hhb-cavities.json");
  EXPECT_NE(json.find("\"volume_sa_clipped_angstrom3\""), json.npos);
  EXPECT_NE(json.find("\"name\": \"alphascope\""), json.npos);
}

TEST_F(CavitiesTest, FilesForOtherProgramsAreThoseOfTheCommandLine) {
  open_cavities();
  use_preset();
  run("click cavities.least\nkey ctrl+a\ntype 60\nkey enter\nframes 3\n");
  const std::string file = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
  const auto by_command_line = [&](const std::string& options) {
    ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && " ALPHASCOPE_CLI " cavities -q '" +
                           file + "' --min-volume 60 " + options + " > /dev/null")
                              .c_str()),
              0);
  };
  by_command_line("--surface by.ply --spheres by-spheres.pqr");
  by_command_line("--surface by-surface.glb --spheres by-spheres.pqr --script by.cxc");
  by_command_line("--spheres by-spheres.pqr --script by.pml");
  const auto expected = [&](const std::string& name) {
    std::string text = bytes(name);
    const std::pair<const char*, const char*> other[] = {{"alphascope-cli ", "alphascope "},
                                                         {"by-spheres", "w-spheres"},
                                                         {"by-surface", "w-surface"}};
    for (const auto& [from, to] : other) {
      for (std::size_t at; (at = text.find(from)) != text.npos;) {
        text.replace(at, std::string(from).size(), to);
      }
    }
    return text;
  };
  // Returns a GLB file from its geometry on. The lengths at its beginning depend on the length of
  // the program's name.
  const auto geometry = [](const std::string& glb) {
    return glb.substr(glb.find(std::string("BIN\0", 4)));
  };
  save(folder_ / "w.ply");
  EXPECT_EQ(bytes("w.ply"), expected("by.ply"));
  save(folder_ / "w.pqr");
  EXPECT_EQ(bytes("w.pqr"), expected("by-spheres.pqr"));
  save(folder_ / "w.glb");
  EXPECT_EQ(geometry(bytes("w.glb")), geometry(bytes("by-surface.glb")));
  save(folder_ / "w.pml");
  EXPECT_EQ(bytes("w.pml"), expected("by.pml"));
  EXPECT_EQ(bytes("w-spheres.pqr"), expected("by-spheres.pqr"));
  EXPECT_FALSE(fs::exists(folder_ / "w-surface.glb")) << "PyMOL does not open it";
  save(folder_ / "w.cxc");
  EXPECT_EQ(bytes("w.cxc"), expected("by.cxc"));
  EXPECT_EQ(geometry(bytes("w-surface.glb")), geometry(bytes("by-surface.glb")));
  EXPECT_FALSE(fs::exists(folder_ / "w.cxc.csv"));
  EXPECT_EQ(viewer_->state().notice.text(), "Saved " + (folder_ / "w.cxc").string());
}

TEST_F(CavitiesTest, TheEndingOfTheNameSaysTheFormat) {
  open_cavities();
  const TableState& dialog = viewer_->state().save_table;
  run("click cavities.save\nframes 3\n");
  viewer_->state().save_table.path = (folder_ / "cav.txt").string();
  run("frames 2\n");
  EXPECT_TRUE(has("save_table.ending"));
  run("click save_table.ok\nwait-idle\nframes 3\n");
  EXPECT_NE(dialog.table, nullptr) << "it is still open";
  viewer_->state().save_table.path = (folder_ / "cav.GLB").string();
  run("frames 2\n");
  EXPECT_FALSE(has("save_table.ending"));
  EXPECT_EQ(dialog.format, kFirstOfMore + 1);
  run("click save_table.format\nframes 2\nclick save_table.cxc\nframes 2\n");
  EXPECT_EQ(dialog.path, (folder_ / "cav.cxc").string());
  viewer_->state().save_table.path = (folder_ / "cav").string();
  run("frames 2\nclick save_table.ok\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_TRUE(fs::exists(folder_ / "cav.cxc")) << "the format's ending, where there is none";
  EXPECT_FALSE(fs::exists(folder_ / "cav"));
}

TEST_F(CavitiesTest, WhereATableCannotBeWrittenItSaysSoAndLeavesNothing) {
  open_cavities();
  fs::create_symlink("/dev/full", folder_ / "full.csv");
  save(folder_ / "full.csv");
  EXPECT_NE(viewer_->state().error.find((folder_ / "full.csv").string()), std::string::npos)
      << viewer_->state().error;
  EXPECT_EQ(viewer_->state().notice.text(), "");
  run("click error.ok\nframes 3\n");
  fs::create_directories(folder_ / "folder.csv");  // no file can have its name
  save(folder_ / "folder.csv");
  EXPECT_TRUE(viewer_->widgets().contains("save_table.no_name")) << "before it is tried";
  run("click save_table.cancel\nframes 3\n");
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) files += entry.is_regular_file();
  EXPECT_EQ(files, 0u);
  EXPECT_FALSE(viewer_->busy());
}

TEST_F(CavitiesTest, WhatIsChosenFollowsIntoWhatItMergesWithAndComesBack) {
  open_cavities();
  use_preset();
  run("click cavities.all\nframes 3\n");
  settle();
  // With a smaller probe, some cavities merge. The test chooses one of them.
  const auto at_first = page().rows.lines;
  const auto numbers = at_first->numbers;
  run("solvent.set 1.2\n");
  settle();
  ASSERT_FALSE(page().merged_into.empty());
  const auto merged = page().rows.lines->numbers->merged_into;
  ASSERT_FALSE(merged.empty());
  run("solvent.set 1.4\n");
  settle();
  const std::uint32_t number = merged.begin()->first;
  const std::uint32_t cavity = page().rows.lines->numbers->cavity(number);
  ASSERT_NE(cavity, CavityMatch::kNone) << "it is one of its own again";
  const auto& order = page().rows.table().order;
  const auto row =
      static_cast<std::size_t>(std::find(order.begin(), order.end(), cavity) - order.begin());
  viewer_->state().settings.selection.cavities =
      RefSet({cavity_sink(*page().rows.lines->atoms, page().rows.table(), row)});
  settle();
  ASSERT_EQ(page().selected_rows, std::vector<std::size_t>{row});
  EXPECT_FALSE(has("cavities.merged"));
  run("solvent.set 1.2\n");
  settle();
  ASSERT_EQ(page().selected_rows.size(), 1u);
  EXPECT_EQ(page().merged_into, page().selected_rows);
  EXPECT_TRUE(has("cavities.merged"));
  EXPECT_EQ(viewer_->state().notice.text(), "The selected cavity has merged into cavity " +
                                                std::to_string(page().selected_rows.at(0) + 1) +
                                                ".");
  run("solvent.set 1.4\n");
  settle();
  EXPECT_EQ(page().selected_rows, std::vector<std::size_t>{row});
  EXPECT_FALSE(has("cavities.merged"));
}

TEST_F(CavitiesTest, OfAnotherMoleculeNothingStays) {
  open_cavities();
  run("click cavities.row.1 0.2\nwait-idle\nframes 3\n");
  EXPECT_EQ(page().selected_rows.size(), 1u);
  open_crambin();
  run("wait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_TRUE(viewer_->state().settings.selection.cavities.empty());
  EXPECT_TRUE(page().selected_rows.empty());
  EXPECT_TRUE(viewer_->state().layers.empty());
}

// A grid of 27 balls with all squares open: a network of eight cubes.
TEST_F(CavitiesTest, ANetworkIsSplitAndSaysWhereItFallsApart) {
  const fs::path path = folder_ / "grid.xyzr";
  std::ofstream(path) << grid_of_balls();
  run("open " + path.string() + "\nwait-idle\n");
  run("click bottom.cavities\nsolvent.set 1\n");
  settle();
  ASSERT_EQ(page().rows.size(), 1u);
  EXPECT_TRUE(page().rows.lines->of[0].is_network);
  ASSERT_TRUE(has("cavities.split_networks"));
  ASSERT_TRUE(has("cavities.network.radius"));
  EXPECT_FALSE(has("cavities.falls_apart"));
  run("click cavities.row.1 0.2\n");
  settle();
  ASSERT_TRUE(has("cavities.falls_apart"));
  run("click cavities.split_networks 0.05\n");
  settle();
  ASSERT_EQ(page().rows.size(), 8u);
  for (const CavityLine& line : page().rows.lines->of) EXPECT_TRUE(line.is_part);
  EXPECT_EQ(page().selected_rows.size(), 1u) << "the part of the same deepest point";
  EXPECT_FALSE(has("cavities.falls_apart"));
  EXPECT_TRUE(has("cavities.networks"));
  run("edit.undo\n");
  settle();
  EXPECT_EQ(viewer_->state().notice.text(), "Undone: selection and networks of cavities");
  ASSERT_EQ(page().rows.size(), 1u);
  run("click cavities.network.radius\n");
  settle();
  EXPECT_EQ(viewer_->state().settings.request.solvent_radius_angstrom, 1.5);
  EXPECT_EQ(page().rows.size(), 8u);
  EXPECT_EQ(page().rows.table().voids, 8u);
  run("solvent.set 1\n");
  settle();
  run("cavities.split_networks on\n");
  settle();
  EXPECT_EQ(page().rows.size(), 8u);
}

TEST_F(CavitiesTest, WithoutAMoleculeItSaysWhatToDo) {
  run("click bottom.cavities\n");
  EXPECT_TRUE(has("cavities.waiting"));
  EXPECT_FALSE(has("cavities.totals"));
}

}  // namespace
}  // namespace alphascope::testing
