// SPDX-License-Identifier: GPL-3.0-or-later
// Tests atoms outside the body: they are drawn, named and selected, and never computed with.
#include "ui/scene/mesh/beside_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/session/open_molecule.hpp"
#include "core/bonds/bonds.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
constexpr std::size_t kStickPoints = 2 * 2 * 8;  // two halves of two rings

class BesideBodyTest : public ::testing::Test {
 protected:
  BesideBodyTest() {
    OpenOptions options;
    options.balls.ligands = false;
    opened_ = open_molecule(kHaemoglobin, options, {});
  }
  BesideBody built(const AtomsBesideBody& shown) {
    const BallGeometry balls(*opened_.prepared->balls);
    const BondList bonds = find_bonds(*opened_.molecule, opened_.molecule->models.front());
    return build_beside_body(balls, *opened_.molecule, *opened_.prepared, bonds.bonds, shown);
  }
  OpenedMolecule opened_;
};

TEST_F(BesideBodyTest, LigandsHaveBallsAndTheirBonds) {
  const BesideBody atoms = built({});
  ASSERT_EQ(atoms.atoms.size(), 174u);  // four haems of 43 atoms, two phosphorus atoms
  ASSERT_TRUE(atoms.mesh);
  EXPECT_EQ(atoms.mesh->opaque.spheres->centres.size(), 174u);
  // A haem has 43 atoms and eight independent rings, those at the iron included, so 50 bonds. The
  // file lists all of them.
  EXPECT_EQ(atoms.mesh->tubes.points(), 200 * kStickPoints);
  EXPECT_FALSE(atoms.mesh->fades_rest);
  const LatticePoint& p = opened_.molecule->atoms[atoms.atoms[7].atom].position;
  const double x = opened_.molecule->lattice.angstrom(p.x);
  EXPECT_NEAR(atoms.mesh->opaque.spheres->centres[7][0] + atoms.mesh->opaque.spheres->origin[0], x,
              1e-4);
}

TEST_F(BesideBodyTest, EachKindIsASwitch) {
  EXPECT_EQ(built({false, false, false, false}).mesh, nullptr);
  EXPECT_EQ(built({false, true, false, true}).atoms.size(), 0u) << "there are no ions here";
  EXPECT_EQ(built({false, false, true, false}).atoms.size(), 221u);
  EXPECT_EQ(built({true, true, true, true}).atoms.size(), 174u + 221u);
}

TEST_F(BesideBodyTest, HydrogensAreBoundToTheirResidue) {
  const fs::path file = fs::temp_directory_path() / "alphascope_glycine.pdb";
  std::ofstream(file)
      << "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N\n"
         "ATOM      2  CA  GLY A   1       1.460   0.000   0.000  1.00  0.00           C\n"
         "ATOM      3  C   GLY A   1       2.000   1.400   0.000  1.00  0.00           C\n"
         "ATOM      4  O   GLY A   1       3.200   1.500   0.000  1.00  0.00           O\n"
         "ATOM      5  H   GLY A   1      -0.400   0.500   0.800  1.00  0.00           H\n"
         "ATOM      6  HA2 GLY A   1       1.800  -0.600   0.800  1.00  0.00           H\n"
         "ATOM      7  HA3 GLY A   1       1.800  -0.600  -0.800  1.00  0.00           H\n";
  OpenOptions options;
  options.balls.hydrogens = HydrogenRule::drop;
  opened_ = open_molecule(file, options, {});
  fs::remove(file);
  EXPECT_EQ(built({}).atoms.size(), 0u);
  const BesideBody atoms = built({true, true, false, true});
  EXPECT_EQ(atoms.atoms.size(), 3u);
  EXPECT_EQ(atoms.mesh->tubes.points(), 3 * kStickPoints) << "one bond each";
}

class BesideBodyInTheWindow : public ViewerTest {
 protected:
  void open_without_ligands() {
    run("open " + kHaemoglobin + "\nwait-idle\n");
    viewer_->state().settings.open.balls.ligands = false;
    run("frames 2\nwait-idle\nframes 2\n");
  }
  ViewState& state() { return viewer_->state(); }
};

TEST_F(BesideBodyInTheWindow, TheyAreDrawnInSavedPicturesTooAndNeverComputedWith) {
  open_without_ligands();
  const std::uint64_t hash = state().result->complex.hash;
  const std::size_t balls = state().molecule.balls;
  const auto saved = [&] {
    viewer_->calls().jobs.save_picture(
        ScreenshotRequest{folder_ / "saved.png", {.width = 400, .height = 300}});
    run("wait-idle\n");
    return pixels_of(folder_ / "saved.png");
  };
  const Image with = picture(), saved_with = saved();
  run("view.left_out_ligands off\nwait-idle\n");
  EXPECT_EQ(state().undo_text, "atoms beside the body");
  const Image without = picture();
  EXPECT_GT(differing_pixels(with, without), 300);
  EXPECT_GT(differing_pixels(saved_with, saved()), 50);
  run("view.left_out_waters on\nwait-idle\n");
  EXPECT_GT(differing_pixels(picture(), without), 300);
  EXPECT_EQ(state().result->complex.hash, hash);
  EXPECT_EQ(state().molecule.balls, balls);
  run("edit.undo\nwait-idle\nedit.undo\nwait-idle\n");
  EXPECT_EQ(differing_pixels(picture(), with), 0);
}

TEST_F(BesideBodyInTheWindow, TheMouseNamesAndSelectsThem) {
  open_without_ligands();
  run("view.balls off\nview.tetrahedra off\nwait-idle\n");
  // Somewhere the picture shows an atom of a ligand.
  std::string found;
  for (int k = 0; k < 400 && found.empty(); ++k) {
    const std::string at =
        std::to_string(0.2 + 0.03 * (k % 20)) + " " + std::to_string(0.2 + 0.03 * (k / 20));
    run("move view " + at + "\nframes 1\n");
    if (!state().viewport.under_mouse_line.empty()) found = at;
  }
  ASSERT_FALSE(found.empty());
  EXPECT_NE(state().viewport.under_mouse_line.find("ligand, not in the body"), std::string::npos)
      << state().viewport.under_mouse_line;
  run("click view " + found + "\nframes 2\n");
  ASSERT_EQ(state().settings.selection.items.size(), 1u);
  EXPECT_EQ(state().selected_missing, 0u);
  run("view.left_out_ligands off\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().selected_missing, 1u);
}

// Like ViewerTest's picture, with a cavity chosen: its surface, rims and the haems, and all else
// pale.
TEST_F(BesideBodyInTheWindow, ASavedPictureShowsWhatPanelsDraw) {
  open_without_ligands();
  run("click bottom.cavities\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  const Image plain = upright(picture());
  run("click cavities.row.1 0.2\nwait-idle\nframes 3\n");
  state().settings.selection.items = {};  // no saved picture shows the selection
  run("frames 2\nwait-idle\n");
  ASSERT_FALSE(state().layers.empty());
  const Image shown = upright(picture());
  EXPECT_GT(differing_pixels(plain, shown), 1000);
  const ViewportInfo& v = state().viewport;
  viewer_->calls().jobs.save_picture(ScreenshotRequest{
      folder_ / "saved.png", {.width = v.width, .height = v.height, .legend = false}});
  run("wait-idle\n");
  const Image saved = pixels_of(folder_ / "saved.png");
  ASSERT_EQ(saved.width, shown.width);
  EXPECT_LE(differing_pixels(saved, shown), shown.width * shown.height / 1000);
}

TEST(BesideBodyOnTheCommandLine, ScreenshotDrawsThemToo) {
  const fs::path file = fs::temp_directory_path() / "alphascope_beside.png";
  const auto drawn = [&](const std::string& options) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + kHaemoglobin +
                                " --alpha 0 --no-ligands --size 300x200 -q -o " + file.string() +
                                " " + options + " > /dev/null 2>&1";
    return std::system(command.c_str()) == 0 ? pixels_of(file) : Image{};
  };
  const Image with = drawn(""), without = drawn("--beside none");
  ASSERT_GT(with.width, 0);
  EXPECT_GT(differing_pixels(with, without), 30);
  EXPECT_GT(differing_pixels(drawn("--beside waters"), without), 30);
  EXPECT_EQ(drawn("--beside sugar").width, 0);
  fs::remove(file);
}

}  // namespace
}  // namespace alphascope::testing
