// SPDX-License-Identifier: GPL-3.0-or-later
// Tests texts on how balls were made.
#include "core/selection/provenance.hpp"

#include <map>

#include "core/molecule/assembly.hpp"
#include "core/radii/radii_set.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

TEST(Provenance, SaysFileChoicesAndRounding) {
  const Molecule m = read_text("a.xyzr", "1.12345678 2 3 1.5 CA\n5 6 7 1.5 O\n");
  BallOptions options;
  options.selection = "element C";
  options.altlocs = AltlocRule::all;
  options.ions = false;
  const PreparedBalls prepared = prepare_balls(m, options);
  const Provenance list = provenance(m, options, prepared.report);
  const std::map<std::string, std::string> said(list.begin(), list.end());
  EXPECT_EQ(said.size(), 13u);
  EXPECT_TRUE(said.at("file").ends_with("a.xyzr"));
  EXPECT_EQ(said.at("fetched"), "");
  EXPECT_EQ(said.at("sha256"), m.sha256);
  EXPECT_EQ(said.at("format"), "XYZR");
  EXPECT_EQ(said.at("model"), "1");
  EXPECT_EQ(said.at("assembly"), "");
  EXPECT_EQ(said.at("options"), "--altlocs all --no-ions");
  EXPECT_EQ(said.at("selection_expression"), "element C");
  EXPECT_EQ(said.at("selection"),
            "used 1 of 2 atoms; dropped 1 atom not selected; radii from the file");
  EXPECT_EQ(said.at("radii"), "from the file");
  EXPECT_EQ(said.at("lattice_unit_angstrom"), "0.000001");
  EXPECT_EQ(said.at("rounding_angstrom"), "2.2e-07");
  EXPECT_EQ(said.at("radius_rounding_angstrom"), "0");
}

TEST(Provenance, NamesTheTableAndWhatWasSetByHand) {
  const Molecule m = read_text("a.xyzr", "1 2 3 1.5 CA\n5 6 7 1.5 O\n");
  BallOptions options;
  options.radii = RadiiSet::user;
  auto table = std::make_shared<UserRadii>();
  table->source = "mine.txt";
  table->sha256 = "0123";
  table->by_element[6] = 1700000;
  options.user_radii = table;
  options.overrides = {{"", "O", 8, 1234567}};
  const Provenance list = provenance(m, options, prepare_balls(m, options).report);
  const std::map<std::string, std::string> said(list.begin(), list.end());
  EXPECT_EQ(said.at("radii"), "user table mine.txt (sha256 0123); by hand O 1.234567");
}

TEST(Provenance, OptionsAreTheCommandLines) {
  BallOptions options;
  EXPECT_EQ(options_text(options), "");
  options.hydrogens = HydrogenRule::drop;
  options.waters = options.dummies = true;
  options.ligands = options.polymers = false;
  options.chains = {"A", "B-2"};
  options.without_chains = {"C"};
  options.treated = {"A:PU8 301=ligand"};
  EXPECT_EQ(options_text(options),
            "--hydrogens drop --chain A,B-2 --without-chain C --waters --dummies --no-ligands "
            "--no-polymers --treat 'A:PU8 301=ligand'");
  EXPECT_EQ(model_text(0), "1");
  EXPECT_EQ(model_text(kAllModels), "joined");
}

}  // namespace
}  // namespace alphascope
