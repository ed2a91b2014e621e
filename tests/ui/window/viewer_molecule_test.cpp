// SPDX-License-Identifier: GPL-3.0-or-later
// Tests opening, selecting, expanding and playing in the whole window against the session's own
// answers.
#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/assembly.hpp"
#include "tests/support/dimer.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using testing::crambin;
using testing::ViewerTest;

fs::path haemoglobin() {
  return fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz";
}

class ViewerMoleculeTest : public ViewerTest {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  // Each model has four atoms. Models differ, and so do their complexes.
  fs::path models(int count) {
    std::string text;
    for (int m = 1; m <= count; ++m) {
      text += "4\nmodel\nC 0 0 0\nC 1.5 0 0\nC 0 1.5 0\nC 0 0 " + std::to_string(0.5 * m) + "\n";
    }
    return write("models.xyz", text);
  }

  void open_file(const fs::path& path) { run("open " + path.string() + "\nwait-idle\n"); }
  const MoleculeInfo& molecule() { return viewer_->state().molecule; }
  std::string hash() { return hash_text(viewer_->state().result->complex.hash); }

  // The hash for the same file and options, computed as the command line does.
  std::string expected_hash(const fs::path& path, const OpenOptions& options) {
    const OpenedMolecule opened = open_molecule(path, options, {});
    return hash_text(make_cgal_engine(opened.prepared->balls)->compute({0, false}, {}).hash);
  }
};

TEST_F(ViewerMoleculeTest, EveryToggleGivesTheComplexOfItsRule) {
  open_file(haemoglobin());
  run("click molecule.waters\nwait-idle\n");
  OpenOptions options;
  options.balls.waters = true;
  EXPECT_EQ(hash(), expected_hash(haemoglobin(), options));
  run("click molecule.ligands\nwait-idle\n");
  options.balls.ligands = false;
  EXPECT_EQ(hash(), expected_hash(haemoglobin(), options));
  run("click molecule.chains\nclick molecule.chain.B\nkey escape\nwait-idle\n");
  options.balls.without_chains = {"B"};
  EXPECT_EQ(hash(), expected_hash(haemoglobin(), options));
  run("click molecule.expression\ntype resi 1-50\nkey enter\nwait-idle\n");
  options.balls.selection = "resi 1-50";
  EXPECT_EQ(hash(), expected_hash(haemoglobin(), options));
  EXPECT_NE(molecule().summary.find("not selected"), std::string::npos) << molecule().summary;
}

// A command may change the view before a new molecule is first drawn. The first drawing fits the
// view, and must not undo the command.
TEST_F(ViewerMoleculeTest, AViewAskedForBeforeTheFirstDrawingFitsAllTheSame) {
  const auto saved = [&](const std::string& name) {
    run("view.save_camera " + name + "\nframes 2\n");
    return viewer_->state().settings.views.back();
  };
  open_file(haemoglobin());
  run("view.from y\nwait-idle\n");
  const NamedView expected = saved("expected");
  open_file(crambin());
  const auto before = viewer_->state().result;
  viewer_->calls().files.open(haemoglobin());
  ScriptedInput input;
  const auto opened = [&] {
    const auto& result = viewer_->state().result;
    return result && result != before;
  };
  for (int k = 0; k < 10000 && !opened(); ++k) {
    viewer_->calls().view.look_from(std::array<double, 3>{0, 1, 0});
    viewer_->step(&input);
  }
  ASSERT_TRUE(opened());
  run("wait-idle\n");
  EXPECT_EQ(molecule().name, "4hhb.pdb.gz");
  const NamedView found = saved("found");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.position[k], expected.position[k], 1e-6);
    EXPECT_NEAR(found.focal_point[k], expected.focal_point[k], 1e-6);
  }
}

TEST_F(ViewerMoleculeTest, ABadExpressionChangesNothingAndStaysToBeMended) {
  open_crambin();
  const std::string before = hash();
  run("click molecule.expression\ntype chain A)\nkey enter\nwait-idle\n");
  const ViewState& s = viewer_->state();
  EXPECT_EQ(s.expression_error.value().column(), 8u);
  EXPECT_EQ(s.expression.typed, "chain A)");
  EXPECT_TRUE(s.error.empty()) << "beside the field, not as a dialog";
  EXPECT_EQ(hash(), before);
  open_file(haemoglobin());
  EXPECT_FALSE(s.expression_error);
  EXPECT_TRUE(s.expression.typed.empty()) << "of the file before";
}

TEST_F(ViewerMoleculeTest, ATypedRadiusRecomputesAndIsCounted) {
  open_file(haemoglobin());
  const std::string before = hash();
  run("click molecule.radius_list\nclick radius.HEM.FE\nkey ctrl+a\ntype 1.2\nkey enter\n"
      "wait-idle\n");
  OpenOptions options;
  options.balls.overrides = {{"HEM", "FE", element_from_symbol("Fe"), 1200000}};
  EXPECT_EQ(hash(), expected_hash(haemoglobin(), options));
  EXPECT_NE(hash(), before);
  EXPECT_NE(molecule().summary.find("170 guessed; 4 set by hand"), std::string::npos)
      << molecule().summary;
  run("click radius.reset.HEM.FE\nwait-idle\n");
  EXPECT_EQ(hash(), before);
}

TEST_F(ViewerMoleculeTest, ResiduesAreTreatedInTheListUndoneAndSaved) {
  const ViewState& s = viewer_->state();
  open_file(haemoglobin());
  const std::string before = hash();
  const std::size_t balls = molecule().balls;
  run("click molecule.residues\nclick residue.HOH\nclick residue.as.ligand\nwait-idle\n");
  EXPECT_EQ(s.settings.open.balls.treated, std::vector<std::string>{"HOH=ligand"});
  OpenOptions options;
  options.balls.treated = {"HOH=ligand"};
  const std::string treated = expected_hash(haemoglobin(), options);
  EXPECT_EQ(hash(), treated);
  EXPECT_EQ(molecule().balls, balls + 221) << "waters are left out, ligands are not";
  EXPECT_EQ(molecule().residues->by_hand, 221u);
  run("file.save_session " + (folder_ / "s.json").string() + "\nwait-idle\n");
  EXPECT_NE(bytes("s.json").find("\"HOH=ligand\""), std::string::npos);
  run("edit.undo\nwait-idle\n");
  EXPECT_TRUE(s.settings.open.balls.treated.empty());
  EXPECT_EQ(molecule().residues->by_hand, 0u);
  EXPECT_EQ(hash(), before);
  run("edit.redo\nwait-idle\n");
  EXPECT_EQ(hash(), treated);
  run("click residue.HOH\nclick residue.as.file\nwait-idle\n");
  EXPECT_TRUE(s.settings.open.balls.treated.empty());
  EXPECT_EQ(hash(), before);
}

TEST_F(ViewerMoleculeTest, TreatedResiduesKeepViewSelectionAndAlpha) {
  const ViewState& s = viewer_->state();
  open_file(haemoglobin());
  run("alpha.set 1.4\nselect.atoms A:15\nmove view 0.5 0.5\nwheel 3\nwait-idle\n");
  const auto camera = [&](const std::string& name) {
    run("view.save_camera " + name + "\nframes 2\n");
    return viewer_->state().settings.views.back();
  };
  const NamedView before = camera("before");
  const RefSet picked = s.settings.selection.items;
  ASSERT_FALSE(picked.empty());
  run("click molecule.residues\nclick residue.HOH\nclick residue.as.ligand\nwait-idle\n");
  const NamedView after = camera("after");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(after.position[k], before.position[k], 1e-6) << "they are the same atoms";
    EXPECT_NEAR(after.focal_point[k], before.focal_point[k], 1e-6);
  }
  EXPECT_EQ(s.settings.selection.items, picked);
  EXPECT_DOUBLE_EQ(s.result->request.alpha_angstrom2, 1.4);
  EXPECT_EQ(hash(), hash_text(expected(1.4).hash));
}

TEST_F(ViewerMoleculeTest, AGuessIsShownAtOnceAndConfirmedOrPutRight) {
  const fs::path path =
      write("guess.pdb",
            "ATOM      1  C1  QQ1 A   1       0.000   0.000   0.000  1.00  0.00           C\n"
            "ATOM      2  C2  QQ1 A   1       1.500   0.000   0.000  1.00  0.00           C\n"
            "ATOM      3  O3  QQ1 A   1       0.000   1.500   0.000  1.00  0.00           O\n");
  open_file(path);
  ASSERT_EQ(molecule().residues->of.size(), 1u);
  EXPECT_EQ(molecule().residues->of[0].why, ResidueReason::no_polymer);
  EXPECT_EQ(molecule().residues->guessed, 1u);
  run("click residue.QQ1\nclick residue.as.ligand\nwait-idle\n");
  EXPECT_EQ(viewer_->state().settings.open.balls.treated, std::vector<std::string>{"QQ1=ligand"});
  EXPECT_EQ(molecule().residues->guessed, 0u);
  EXPECT_EQ(molecule().balls, 3u);
  run("click molecule.ligands\nwait-idle\n"
      "click residue.QQ1\nclick residue.as.polymer\nwait-idle\n");
  EXPECT_EQ(viewer_->state().settings.open.balls.treated, std::vector<std::string>{"QQ1=polymer"});
  EXPECT_EQ(molecule().balls, 3u) << "no ligand any more";
  open_crambin();
  EXPECT_TRUE(viewer_->state().settings.open.balls.treated.empty()) << "of the file before";
}

TEST_F(ViewerMoleculeTest, AClickOnANameSelectsItsAtoms) {
  open_file(haemoglobin());
  run("click molecule.residues\nclick residue.name.HEM\nwait-idle\n");
  EXPECT_EQ(viewer_->state().settings.selection.items.size(), 4u * 43u);
}

TEST_F(ViewerMoleculeTest, ATableOfRadiiIsUsedAndABadOneTakenBack) {
  open_crambin();
  const fs::path good = write("radii.txt", "C 1.9\nN 1.8\nO 1.7\nS 2.0\n");
  const fs::path bad = write("bad.txt", "C much\n");
  const std::string choose =
      "click molecule.radii\nclick molecule.radii.user\nclick browser.path\n"
      "key ctrl+a\ntype ";
  run(choose + good.string() + "\nkey enter\nwait-idle\n");
  EXPECT_NE(molecule().summary.find("radii user table"), std::string::npos) << molecule().summary;
  const std::string with_table = hash();
  run(choose + bad.string() + "\nkey enter\nwait-idle\n");
  EXPECT_NE(viewer_->state().error.find("bad.txt, line 1"), std::string::npos);
  EXPECT_EQ(hash(), with_table);
  EXPECT_EQ(viewer_->state().settings.open.radii_table, good);
}

TEST_F(ViewerMoleculeTest, AnAssemblyIsExpandedAndComesBack) {
  const fs::path path = write(
      "dimer.pdb",
      std::string(testing::kDimerRemark) +
          "ATOM      1  N   MET A   1       1.000   1.000   3.000  1.00  9.67           N  \n"
          "ATOM      2  CA  MET A   1       1.000   1.500   4.000  1.00  9.67           C  \n");
  open_file(path);
  ASSERT_EQ(molecule().assemblies.size(), 1u);
  EXPECT_EQ(molecule().assemblies[0].copies, 2u);
  EXPECT_EQ(molecule().balls, 2u);
  const std::string deposited = hash();
  run("click molecule.chains\nclick molecule.chain.A\nkey escape\nwait-idle\n");
  EXPECT_EQ(molecule().balls, 0u);
  run("click molecule.assembly\nclick molecule.assembly.1\nwait-idle\n");
  EXPECT_EQ(molecule().balls, 4u) << "chains of the assembly have other names";
  OpenOptions options;
  options.assembly = "1";
  EXPECT_EQ(hash(), expected_hash(path, options));
  run("click molecule.assembly\nclick molecule.assembly.deposited\nwait-idle\n");
  EXPECT_EQ(hash(), deposited);
}

TEST_F(ViewerMoleculeTest, AModelKeepsAlphaAndGivesItsOwnComplex) {
  const fs::path path = models(5);
  open_file(path);
  run("click alpha.preset.1.4\nwait-idle\nclick molecule.model 0.99\nwait-idle\n");
  const ViewState& s = viewer_->state();
  EXPECT_EQ(s.settings.open.balls.model, 4);
  EXPECT_DOUBLE_EQ(s.result->request.alpha_angstrom2, 1.4);
  EXPECT_EQ(hash_text(s.result->complex.hash), hash_text(expected(1.4).hash));
  EXPECT_EQ(viewer_->session().state().prepared->atom_of_ball.front(), 16u);
  run("click molecule.every_model\nwait-idle\n");
  EXPECT_EQ(s.molecule.balls, 20u);
  EXPECT_DOUBLE_EQ(s.result->request.alpha_angstrom2, 1.4);
}

TEST_F(ViewerMoleculeTest, PlayingShowsModelAfterModelEachWithItsComplex) {
  open_file(models(6));
  viewer_->state().playback.models_per_second = 30;
  run("click molecule.play\n");
  std::vector<int> seen;
  ScriptedInput no_input;
  const auto& state = viewer_->session().state();
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (seen.size() < 14 && std::chrono::steady_clock::now() < deadline) {
    viewer_->step(&no_input);
    if (!state.ours) continue;
    const int model = static_cast<int>(state.ours->prepared->atom_of_ball.front()) / 4;
    if (seen.empty() || seen.back() != model) seen.push_back(model);
    EXPECT_TRUE(viewer_->state().result) << "never an empty window between two models";
  }
  ASSERT_EQ(seen.size(), 14u);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i], (seen[i - 1] + 1) % 6) << "every model is computed and shown";
  }
  run("click molecule.play\nwait-idle\n");
  EXPECT_FALSE(viewer_->state().playback.models);
  EXPECT_EQ(hash(), hash_text(expected(0).hash));
}

TEST_F(ViewerMoleculeTest, AModelSliderStormEndsAtTheLastModel) {
  open_file(models(40));
  std::string moves = "move molecule.model 0.1\ndown\n";
  for (int i = 0; i < 100; ++i) {
    moves += "move molecule.model " + std::to_string(0.1 + 0.8 * ((i * 37) % 100) / 100) + "\n";
  }
  run(moves + "move molecule.model 0.5\nup\nwait-idle\n");
  const ViewState& s = viewer_->state();
  EXPECT_EQ(viewer_->session().state().prepared->atom_of_ball.front(),
            4u * s.settings.open.balls.model);
  EXPECT_EQ(hash(), hash_text(expected(0).hash));
  EXPECT_TRUE(s.error.empty()) << s.error;
}

TEST_F(ViewerMoleculeTest, AFailedOpenKeepsControlsAndMolecule) {
  open_file(models(5));
  run("click molecule.model 0.99\nwait-idle\n");
  const std::string before = hash();
  const OpenOptions options = viewer_->state().settings.open;
  open_file(write("bad.pdb", "ATOM      1  CA  ALA A   1      nonsense\n"));
  EXPECT_FALSE(viewer_->state().error.empty());
  run("click error.ok\n");
  EXPECT_EQ(viewer_->state().settings.open, options);
  EXPECT_EQ(hash(), before);
  open_crambin();
  EXPECT_EQ(viewer_->state().settings.open.balls.model, 0);
  EXPECT_TRUE(viewer_->state().error.empty()) << viewer_->state().error;
}

}  // namespace
}  // namespace alphascope
