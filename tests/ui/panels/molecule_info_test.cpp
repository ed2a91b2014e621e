// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the description of a molecule that panels get.
#include "app/viewer/molecule_info.hpp"

#include <gtest/gtest.h>

#include "app/session/open_molecule.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/selection_expression.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {
namespace {

constexpr const char* kTwoModels =
    "MODEL        7\n"
    "ATOM      1  N   ALA A   1      27.340  24.430   2.614  1.00  9.67           N  \n"
    "HETATM    2 FE   HEM B   3       1.266  25.413   8.842  1.00 10.38          FE  \n"
    "HETATM    3  O   HOH A   6       3.266  25.413   8.842  1.00 10.38           O  \n"
    "ENDMDL\n"
    "MODEL        9\n"
    "ATOM      1  N   ALA A   1      27.340  24.430   3.614  1.00  9.67           N  \n"
    "HETATM    2 FE   HEM B   3       1.266  25.413   8.842  1.00 10.38          FE  \n"
    "HETATM    3  O   HOH A   6       3.266  25.413   8.842  1.00 10.38           O  \n"
    "ENDMDL\n";

OpenedMolecule open_text(const std::string& text, const OpenOptions& options) {
  const TemporaryFile file("a.pdb", text);
  return open_molecule(file.path(), options, {});
}

std::string value_of(const MoleculeInfo& info, const std::string& key) {
  for (const auto& [k, value] : info.provenance) {
    if (k == key) return value;
  }
  return "(missing)";
}

OpenOptions some_options() {
  OpenOptions options;
  options.balls.model = 1;
  options.balls.radii = RadiiSet::bondi;
  options.balls.overrides = {{"HEM", "FE", element_from_symbol("Fe"), 1500000}};
  options.balls.selection = "chain A,B";
  return options;
}

TEST(MoleculeInfo, TellsEverythingThatIsChosenFrom) {
  const MoleculeInfo info = describe_molecule(open_text(kTwoModels, some_options()));
  EXPECT_EQ(info.models, (std::vector<int>{7, 9}));
  ASSERT_EQ(info.contents.chains.size(), 2u);
  EXPECT_EQ(info.contents.chains[0].name, "A");
  EXPECT_EQ(kinds_text(info.contents.chains[0].kinds), "polymer 2 · water 2");
  EXPECT_EQ(of_kind(info.contents.kinds, ResidueKind::water), 2u);
  ASSERT_EQ(info.dropped.size(), 1u);
  EXPECT_EQ(info.dropped[0].text, "1 water");
  EXPECT_EQ(info.dropped[0].detail, "HOH 1");
  EXPECT_EQ(info.dropped_atoms, 1u);
  ASSERT_EQ(info.radius_rows.size(), 1u);
  EXPECT_EQ(info.radius_rows[0].kind, RadiusRow::Kind::by_hand);
  EXPECT_EQ(info.radius_rows[0].radius.group, (AtomGroup{"HEM", "FE", 26}));
  EXPECT_DOUBLE_EQ(info.radius_rows[0].radius.radius_angstrom, 1.5);
}

TEST(MoleculeInfo, ResiduesAreThoseOfTheModelThatIsUsed) {
  OpenOptions options = some_options();
  options.balls.treated = {"HEM=polymer"};
  const MoleculeInfo one = describe_molecule(open_text(kTwoModels, options));
  EXPECT_EQ(kinds_text(one.residues->kinds), "polymer 2 · water 1");
  EXPECT_EQ(one.residues->by_hand, 1u);
  EXPECT_EQ(value_of(one, "By hand"), "HEM=polymer");
  options.balls.model = kAllModels;
  const MoleculeInfo all = describe_molecule(open_text(kTwoModels, options));
  EXPECT_EQ(kinds_text(all.residues->kinds), "polymer 4 · water 2");
}

TEST(MoleculeInfo, ResiduesFollowTheModelWithoutReadingAnew) {
  const TemporaryFile file("a.pdb", std::string(kTwoModels) +
                                        "MODEL       11\n"
                                        "HETATM    1  O   HOH A   6       3.266  25.413   8.842  "
                                        "1.00 10.38           O  \n"
                                        "ENDMDL\n");
  OpenOptions options;
  const OpenedMolecule first = open_molecule(file.path(), options, {});
  options.balls.model = 2;
  const OpenedMolecule third = reopen_molecule(first, options, {});
  EXPECT_EQ(kinds_text(third.residues->kinds), "water 1");
  options.balls.treated = {"HOH=ligand"};
  const OpenedMolecule treated = reopen_molecule(third, options, {});
  EXPECT_EQ(kinds_text(treated.residues->kinds), "ligand 1");
  EXPECT_TRUE(same_atoms(first, treated));
  OpenedMolecule assembly = treated;
  assembly.options.assembly = "1";
  EXPECT_FALSE(same_atoms(first, assembly));
}

TEST(MoleculeInfo, ProvenanceNamesWhatTheNumbersDependOn) {
  const MoleculeInfo info = describe_molecule(open_text(kTwoModels, some_options()));
  EXPECT_EQ(value_of(info, "SHA-256").size(), 64u);
  EXPECT_EQ(value_of(info, "SHA-256"), info.sha256);
  EXPECT_EQ(value_of(info, "Assembly"), "none: as deposited");
  EXPECT_EQ(value_of(info, "Model"), "2 of 2 (number 9 in the file)");
  EXPECT_EQ(value_of(info, "Expression"), "chain A,B");
  EXPECT_EQ(value_of(info, "Lattice unit"), "0.001 Å");
  EXPECT_EQ(value_of(info, "Rounding"), "none: every digit of the file is kept");
  EXPECT_EQ(value_of(info, "By hand"), "FE in HEM: 1.5 Å (1)");
  EXPECT_NE(value_of(info, "Radii").find("Bondi: A. Bondi"), std::string::npos);
  EXPECT_NE(value_of(info, "Selection").find("used 2 of 3 atoms"), std::string::npos);
}

TEST(MoleculeInfo, DoubtfulElementsComeFirstAndEditsDoNotMoveRows) {
  OpenOptions options;
  options.balls.radii = RadiiSet::protor;  // radii of ligands are guessed
  const std::string text =
      "HETATM    1  C1  AAA B   3       1.266  25.413   8.842  1.00 10.38           C  \n"
      "HETATM    2 ZN   ZZZ B   4       3.266  25.413   8.842  1.00 10.38          ZN  \n";
  const MoleculeInfo before = describe_molecule(open_text(text, options));
  ASSERT_EQ(before.radius_rows.size(), 2u);
  EXPECT_EQ(before.radius_rows[0].radius.group.element, element_from_symbol("Zn"));
  options.balls.overrides = {{"AAA", "C1", 6, 1500000}};
  const MoleculeInfo after = describe_molecule(open_text(text, options));
  EXPECT_EQ(after.radius_rows[1].kind, RadiusRow::Kind::by_hand);
  EXPECT_EQ(after.radius_rows[0].radius.group, before.radius_rows[0].radius.group);
}

TEST(MoleculeInfo, SaysWhenNothingIsLeft) {
  OpenOptions options;
  options.balls.selection = "none";
  const MoleculeInfo info = describe_molecule(open_text(kTwoModels, options));
  ASSERT_FALSE(info.notes.empty());
  EXPECT_NE(info.notes.back().find("The selection has no atoms"), std::string::npos);
}

TEST(MoleculeInfo, GrownRadiiFollowTheSizesInUse) {
  const OpenedMolecule opened = open_text(kTwoModels, some_options());
  Request controls;
  controls.alpha_angstrom2 = 1.4;
  const auto radii = grown_radii(*opened.prepared, controls);
  ASSERT_EQ(radii.size(), 2u);
  for (const GrownRadius& r : radii) {
    EXPECT_NEAR(r.grown, std::sqrt(r.radius * r.radius + 1.4), 1e-12);
  }
}

TEST(MoleculeInfo, AnExpressionAtFaultNamesItsColumn) {
  EXPECT_FALSE(fault_of_selection("chain A and not resn HEM"));
  EXPECT_FALSE(fault_of_selection(""));
  const auto fault = fault_of_selection("chain A)");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->column(), 8u);
  EXPECT_NE(std::string(fault->what()).find("column 8"), std::string::npos);
}

}  // namespace
}  // namespace alphascope
