// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the preset of CASTp's choices, and when settings still match it.
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"
#include "core/molecule/element.hpp"
#include "core/radii/radii_choice.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

std::vector<std::string> differences(const OpenOptions& open, const Request& request,
                                     RadiiSet radii) {
  SelectionReport report;
  report.radii = radii;
  return differences_from_castp(open.balls, report, request);
}

TEST(CavityPreset, IsComparable) {
  OpenOptions open;
  Request request;
  open.assembly = "2";
  open.balls.waters = true;
  open.balls.selection = "chain A";
  open.balls.model = 3;
  open.balls.altlocs = AltlocRule::all;
  open.balls.overrides.push_back({"ALA", "CB", kUnknownElement, 1'000'000});
  request.alpha_angstrom2 = 2;
  request.tetrahedra_only = true;
  use_cavity_preset(open, request, false);
  EXPECT_EQ(open.assembly, "2");  // chosen by the user, as on CASTp's page
  EXPECT_EQ(open.balls.radii, RadiiSet::castp);
  EXPECT_TRUE(request.tetrahedra_only);  // the preset does not decide how it is computed
  EXPECT_EQ(differences(open, request, RadiiSet::castp), std::vector<std::string>());
}

TEST(CavityPreset, ARadiusOfTheFileStays) {
  OpenOptions open;
  Request request;
  use_cavity_preset(open, request, true);
  EXPECT_EQ(open.balls.radii, RadiiSet::file);
  EXPECT_EQ(differences(open, request, RadiiSet::file),
            std::vector<std::string>{"radii from the file"});
}

// Each choice that differs from CASTp's is named, so that no other settings are taken for CASTp's.
TEST(CavityPreset, EveryOtherChoiceIsNamed) {
  OpenOptions preset;
  Request request;
  use_cavity_preset(preset, request, false);
  const auto one = [&](auto change, const char* expected) {
    OpenOptions open = preset;
    change(open.balls);
    EXPECT_EQ(differences(open, request, RadiiSet::castp), std::vector<std::string>{expected});
  };
  one([](BallOptions& b) { b.hydrogens = HydrogenRule::keep; }, "hydrogens are in the body");
  one([](BallOptions& b) { b.waters = true; }, "waters are in the body");
  one([](BallOptions& b) { b.ions = true; }, "ions are in the body");
  one([](BallOptions& b) { b.ligands = true; }, "ligands are in the body");
  one([](BallOptions& b) { b.dummies = true; }, "dummy atoms are in the body");
  one([](BallOptions& b) { b.polymers = false; }, "proteins and nucleic acids are left out");
  one([](BallOptions& b) { b.altlocs = AltlocRule::all; }, "all alternative locations");
  one([](BallOptions& b) { b.model = 1; }, "model 2");
  one([](BallOptions& b) { b.model = kAllModels; }, "all models as one");
  one([](BallOptions& b) { b.chains = {"A"}; }, "not all chains");
  one([](BallOptions& b) { b.without_chains = {"A"}; }, "not all chains");
  one([](BallOptions& b) { b.selection = "chain A"; }, "a selection of atoms");
  one(
      [](BallOptions& b) {
        b.overrides.push_back({"", "", 6, 1'700'000});
      },
      "radii changed by hand");
  one([](BallOptions& b) { b.treated = {"LIG=polymer"}; }, "kinds of residues are set by hand");
  request.solvent_radius_angstrom = 1.2;
  request.alpha_angstrom2 = -0.5;
  EXPECT_EQ(differences(preset, request, RadiiSet::protor),
            (std::vector<std::string>{"radii ProtOr", "solvent radius 1.2 Å instead of 1.4 Å",
                                      "alpha -0.5 Å² instead of 0 Å²"}));
}

TEST(CavityPreset, AGuessedResidueIsNotComparable) {
  OpenOptions open;
  Request request;
  use_cavity_preset(open, request, false);
  SelectionReport report;
  report.radii = RadiiSet::castp;
  EXPECT_TRUE(differences_from_castp(open.balls, report, request).empty());
  report.guessed_residues = 1;
  EXPECT_EQ(differences_from_castp(open.balls, report, request),
            std::vector<std::string>{"the kind of 1 residue is guessed"});
  report.guessed_residues = 2;
  EXPECT_EQ(differences_from_castp(open.balls, report, request),
            std::vector<std::string>{"the kinds of 2 residues are guessed"});
}

}  // namespace
}  // namespace alphascope
