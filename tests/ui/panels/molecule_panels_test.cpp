// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the molecule panel: every option for opening a file has a control, and each control has its
// effect.
#include <algorithm>

#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/panels/molecule/molecule_state.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {
namespace {

using testing::loaded_state;
using testing::Panels;
using testing::Size;

const AtomGroup kIron{"HEM", "FE", 26};

WholeState molecule_state() {
  WholeState s = loaded_state();
  MoleculeInfo& m = s.molecule;
  m.dropped_atoms = 221;
  m.dropped = {{"221 waters", "HOH 221"}};
  m.radius_rows = {{RadiusRow::Kind::guessed, {"FE in HEM", 4, 2.44, "", kIron}},
                   {RadiusRow::Kind::guessed, {"NA in HEM", 4, 1.64, "", {"HEM", "NA", 7}}}};
  m.contents.chains = {{"A", 1168, {1069}}, {"B", 1224, {1123}}};
  m.deposited_atoms = 4779;
  m.assemblies = {{"1", "TETRAMERIC", 1, 4779, 460000}, {"2", "", 1680, 16284240, 1560000000}};
  m.models = {7, 8, 9};
  m.sha256 = std::string(64, 'a');
  m.provenance = {{"File", "/data/4hhb.pdb.gz"}, {"SHA-256", m.sha256}};
  return s;
}

class MoleculePanel : public ::testing::Test {
 protected:
  MoleculePanel() : p({1280, 1200, 1}) {
    p.state = molecule_state();
    p.frame(3);
  }
  OpenOptions& open() { return p.state.settings.open; }
  BallOptions& balls() { return p.state.settings.open.balls; }
  Panels p;
};

TEST_F(MoleculePanel, TogglesSetTheirRule) {
  p.click("molecule.polymers");
  p.click("molecule.waters");
  p.click("molecule.ligands");
  p.click("molecule.ions");
  p.click("molecule.hydrogens.1");
  p.click("molecule.altlocs.1");
  BallOptions expected;
  expected.polymers = expected.ligands = expected.ions = false;
  expected.waters = true;
  expected.hydrogens = HydrogenRule::keep;
  expected.altlocs = AltlocRule::all;
  EXPECT_EQ(balls(), expected);
  EXPECT_FALSE(p.rects.contains("molecule.dummies")) << "only where there are any";
  p.state.molecule.contents.kinds[static_cast<std::size_t>(ResidueKind::dummy)] = 3;
  p.frame(2);
  p.click("molecule.dummies");
  EXPECT_TRUE(balls().dummies);
}

TEST_F(MoleculePanel, ChainsAreSwitchedOneByOneAllNoneAndOnly) {
  p.click("molecule.chains");
  p.click("molecule.chain.B");
  EXPECT_EQ(balls().without_chains, std::vector<std::string>{"B"});
  p.click("molecule.only.B");
  EXPECT_EQ(balls().without_chains, std::vector<std::string>{"A"});
  p.click("molecule.chains.none");
  EXPECT_EQ(balls().without_chains.size(), 2u);
  p.click("molecule.chains.all");
  EXPECT_TRUE(balls().without_chains.empty());
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("molecule.chain.B")) << "Escape closes the list";
}

TEST_F(MoleculePanel, ThousandsOfChainsAreFoundByName) {
  p.state.molecule.contents.chains.clear();
  for (int k = 1; k <= 5040; ++k) {
    p.state.molecule.contents.chains.push_back({"A-" + std::to_string(k), 10, {10}});
  }
  p.frame(2);
  p.click("molecule.chains");
  const auto drawn = std::count_if(p.rects.begin(), p.rects.end(), [](const auto& rect) {
    return rect.first.starts_with("molecule.chain.");
  });
  EXPECT_LT(drawn, 20) << "only what is in sight costs anything";
  p.type("molecule.chains.filter", "A-4711");
  p.click("molecule.chain.A-4711");
  EXPECT_EQ(balls().without_chains, std::vector<std::string>{"A-4711"});
}

TEST_F(MoleculePanel, AnExpressionIsAppliedOnEnterOnly) {
  p.click("molecule.expression");
  ImGui::GetIO().AddInputCharactersUTF8("chain A");
  p.frame(3);
  EXPECT_TRUE(balls().selection.empty());
  p.tap(key::kEnter);
  EXPECT_EQ(balls().selection, "chain A");
}

TEST_F(MoleculePanel, AnErrorIsShownBesideTheFieldUntilItIsEdited) {
  p.state.expression.typed = "chain A)";
  p.state.expression_error.emplace(8, "this ) has no opening (");
  p.frame(2);
  ASSERT_TRUE(p.rects.contains("molecule.expression.error"));
  EXPECT_EQ(p.state.expression.typed, "chain A)") << "to be mended, not typed again";
  const float below = p.rects["molecule.expression.error"].y0 - p.rects["molecule.expression"].y1;
  EXPECT_LT(below, 20);
  p.click("molecule.expression");
  p.tap(key::kBackspace);
  EXPECT_FALSE(p.rects.contains("molecule.expression.error"));
}

TEST_F(MoleculePanel, ASmallAssemblyIsChosenAtOnce) {
  p.click("molecule.assembly");
  p.click("molecule.assembly.1");
  EXPECT_EQ(open().assembly, "1");
  p.click("molecule.assembly");
  p.click("molecule.assembly.deposited");
  EXPECT_TRUE(open().assembly.empty());
}

TEST_F(MoleculePanel, ALargeAssemblyIsAskedAbout) {
  p.state.free_bytes = 2'000'000'000;
  p.click("molecule.assembly");
  p.click("molecule.assembly.2");
  p.frame(2);
  EXPECT_TRUE(open().assembly.empty()) << "not yet";
  ASSERT_TRUE(p.rects.contains("assembly.expand"));
  EXPECT_TRUE(p.rects.contains("assembly.too_large")) << "16 million atoms in 2 GB";
  p.click("assembly.cancel");
  p.frame(2);
  EXPECT_TRUE(open().assembly.empty());
  EXPECT_FALSE(p.rects.contains("assembly.expand"));
  p.state.free_bytes = 200'000'000'000;
  p.click("molecule.assembly");
  p.click("molecule.assembly.2");
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("assembly.too_large"));
  p.click("assembly.expand");
  EXPECT_EQ(open().assembly, "2");
}

TEST_F(MoleculePanel, ModelsHaveASliderAndPlay) {
  p.click("molecule.model", 0.95f);
  EXPECT_EQ(balls().model, 2);
  p.click("molecule.play");
  EXPECT_TRUE(p.state.playback.models);
  p.click("molecule.model", 0.05f);
  EXPECT_EQ(balls().model, 0);
  EXPECT_FALSE(p.state.playback.models) << "the hand takes over";
  p.click("molecule.every_model");
  EXPECT_EQ(balls().model, kAllModels);
  p.click("molecule.every_model");
  EXPECT_EQ(balls().model, 0);
}

TEST_F(MoleculePanel, TheNumberOfTheModelIsBesideItsSlider) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{24}, std::size_t{10000}}) {
    p.state.molecule.models.assign(count, 1);
    for (const int model :
         {0, static_cast<int>(count / 2), static_cast<int>(count) - 1, kAllModels}) {
      p.state.settings.open.balls.model = model;
      p.frame(2);
      const WidgetRect slider = p.rects["molecule.model"], text = p.rects["molecule.model.text"];
      EXPECT_GE(text.x0, slider.x1) << count << ", model " << model;
      EXPECT_GE(slider.x1 - slider.x0, 32) << count;
      EXPECT_LE(text.x1, p.rects["view"].x0) << count;
    }
  }
}

TEST_F(MoleculePanel, AModelCanBeTyped) {
  p.state.molecule.models.assign(24, 1);
  p.frame(2);
  p.point_at("molecule.model");
  ImGui::GetIO().KeyCtrl = true;
  p.press(true);
  p.press(false);
  ImGui::GetIO().KeyCtrl = false;
  ImGui::GetIO().AddInputCharactersUTF8("17");
  p.frame(2);
  p.tap(key::kEnter);
  EXPECT_EQ(balls().model, 16);
}

TEST_F(MoleculePanel, ARadiusIsTypedAndReset) {
  p.click("molecule.radius_list");
  p.type("radius.HEM.FE", "1.5");
  EXPECT_EQ(balls().overrides, (std::vector<RadiusOverride>{{kIron, 1'500'000}}));
  EXPECT_FALSE(p.rects.contains("radius.reset.HEM.FE")) << "not before it is in force";
  p.state.molecule.radius_rows[0].kind = RadiusRow::Kind::by_hand;
  p.state.molecule.radius_rows[0].radius.radius_angstrom = 1.5;
  p.frame(2);
  p.click("radius.reset.HEM.FE");
  EXPECT_TRUE(balls().overrides.empty());
  p.type("radius.HEM.NA", "1.7");
  p.type("radius.HEM.FE", "1.6");
  EXPECT_EQ(balls().overrides.size(), 2u);
  p.click("radius.reset_all");
  EXPECT_TRUE(balls().overrides.empty());
}

TEST_F(MoleculePanel, NoRadiusOfZeroCanBeTyped) {
  p.click("molecule.radius_list");
  for (const char* bad : {"0", "-2", "iron", "900"}) {
    p.type("radius.HEM.FE", bad);
    EXPECT_TRUE(balls().overrides.empty()) << bad;
    ASSERT_TRUE(p.rects.contains("radius.error")) << bad;
    EXPECT_NE(testing::memory_of<MoleculeState>(p.panels, "molecule").radius_error.find(bad),
              std::string::npos);
  }
}

TEST_F(MoleculePanel, RadiiOfTheFileNeedAFileThatHasThem) {
  p.click("molecule.radii");
  p.click("molecule.radii.file");
  EXPECT_EQ(balls().radii, RadiiSet::automatic);
  p.state.molecule.has_file_radii = true;
  p.frame(2);
  p.click("molecule.radii.file");
  EXPECT_EQ(balls().radii, RadiiSet::file);
}

TEST_F(MoleculePanel, EveryRadiiSetIsOffered) {
  p.click("molecule.radii");
  for (const RadiiSetInfo& info : all_radii_sets()) {
    EXPECT_TRUE(p.rects.contains("molecule.radii." + std::string(info.id))) << info.id;
  }
}

TEST_F(MoleculePanel, AUserTableIsChosenInTheFileDialog) {
  p.click("molecule.radii");
  p.click("molecule.radii.user");
  p.frame(3);
  EXPECT_EQ(balls().radii, RadiiSet::automatic) << "not before there is a file";
  ASSERT_TRUE(p.rects.contains("browser.path"));
  const std::string table =
      std::string(ALPHASCOPE_SOURCE_DIR) + "/resources/molecules/1crn.pdb";  // an existing file
  p.type("browser.path", table);
  p.frame(2);
  EXPECT_EQ(balls().radii, RadiiSet::user);
  EXPECT_EQ(open().radii_table, table);
  EXPECT_FALSE(p.asked.open) << "it is no molecule";
}

TEST_F(MoleculePanel, TheHashIsCopiedWhole) {
  p.click("molecule.provenance");
  p.click("provenance.sha256");
  EXPECT_STREQ(ImGui::GetClipboardText(), std::string(64, 'a').c_str());
  p.click("provenance.copy");
  EXPECT_NE(std::string(ImGui::GetClipboardText()).find("File: /data/4hhb.pdb.gz\nSHA-256: aaaa"),
            std::string::npos);
}

TEST(MenuTest, EscapeClosesMenusAndLists) {
  Panels p({1280, 800, 1});
  p.state = molecule_state();
  p.frame(2);
  for (const auto& [opener, item] : {std::pair{"menu.File", "menu.file.open"},
                                     {"molecule.radii", "molecule.radii.bondi"},
                                     {"molecule.sample", "molecule.sample.0"},
                                     {"molecule.assembly", "molecule.assembly.1"}}) {
    p.click(opener);
    EXPECT_TRUE(p.rects.contains(item)) << opener;
    p.tap(key::kEscape);
    p.frame(2);
    EXPECT_FALSE(p.rects.contains(item)) << opener;
  }
  EXPECT_FALSE(p.asked.cancel) << "the menu had the key";
}

TEST_F(MoleculePanel, AnEmptySelectionIsExplainedInTheView) {
  EXPECT_FALSE(p.rects.contains("view.nothing"));
  p.state.molecule.balls = 0;
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("view.nothing"));
}

TEST_F(MoleculePanel, EscapeStopsPlayingBeforeItCancels) {
  p.state.jobs = {{JobId::computing, "Computing", "", 0.4, 0.01}};
  p.state.playback.models = true;
  p.tap(key::kEscape);
  EXPECT_FALSE(p.state.playback.models);
  EXPECT_FALSE(p.asked.cancel) << "the model at hand still gets its complex";
  p.tap(key::kEscape);
  EXPECT_TRUE(p.asked.cancel);
}

class MoleculePanelAtEverySize : public ::testing::TestWithParam<Size> {};

TEST_P(MoleculePanelAtEverySize, NothingLeavesThePanelAndAlphaIsInSight) {
  const Size size = GetParam();
  Panels p(size);
  p.state = molecule_state();
  p.frame(3);
  for (const char* name :
       {"molecule.assembly", "molecule.play", "molecule.model", "molecule.speed", "molecule.radii",
        "molecule.waters", "molecule.hydrogens.2", "molecule.altlocs.1", "molecule.chains",
        "molecule.expression", "molecule.expression.help"}) {
    ASSERT_TRUE(p.rects.contains(name)) << name;
    EXPECT_GT(p.rects[name].x1, p.rects[name].x0) << name;
    EXPECT_LE(p.rects[name].x1, p.rects["view"].x0) << name;
  }
  EXPECT_LE(p.rects["alpha.slider"].y1, size.height * size.scale) << "without scrolling";
}

INSTANTIATE_TEST_SUITE_P(Sizes, MoleculePanelAtEverySize,
                         ::testing::Values(Size{1100, 700, 1}, Size{1280, 800, 1},
                                           Size{1920, 1080, 1}, Size{1280, 800, 2}));

}  // namespace
}  // namespace alphascope
