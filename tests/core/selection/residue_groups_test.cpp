// SPDX-License-Identifier: GPL-3.0-or-later
// Tests residues by name and decision, and their names in treatments.
#include "core/selection/residue_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {
namespace {

using Why = ResidueReason;
using Texts = std::vector<std::string>;

// One model of chain A.
class ResidueGroupsTest : public ::testing::Test {
 protected:
  void add(const char* residue, int number, ResidueKind kind, Why why, int atoms = 1) {
    for (int k = 0; k < atoms; ++k) {
      Atom atom;
      atom.chain = atom.label_chain = file_.names.intern("A");
      atom.residue_name = file_.names.intern(residue);
      atom.residue_number = number;
      atom.name = file_.names.intern("C" + std::to_string(k));
      atom.kind = kind;
      atom.why = why;
      file_.atoms.push_back(atom);
    }
  }
  // Adds two lysines of a chain and a free one, two guessed residues, and a water.
  void add_sample() {
    add("LYS", 1, ResidueKind::polymer, Why::chain_bond, 9);
    add("LYS", 2, ResidueKind::polymer, Why::chain_bond, 9);
    add("LYS", 301, ResidueKind::ligand, Why::after_ter, 9);
    add("QQ1", 302, ResidueKind::ligand, Why::no_polymer, 2);
    add("QQ1", 303, ResidueKind::ligand, Why::no_polymer, 2);
    add("HOH", 304, ResidueKind::water, Why::water_name);
  }
  ResidueGroups groups(const Texts& treatments = {}) {
    Molecule molecule = file_;
    molecule.models = {{1, 0, molecule.atoms.size()}};
    const TreatedAtoms treated = apply_treatments(molecule, treatments);
    return residue_groups(file_, molecule, 0, molecule.atoms.size(), treatments, treated);
  }
  Molecule file_;
};

Texts names(const ResidueGroups& groups) {
  Texts names;
  for (const ResidueGroup& group : groups.of) {
    names.push_back(group.name + (group.nth > 1 ? "." + std::to_string(group.nth) : ""));
  }
  return names;
}

TEST_F(ResidueGroupsTest, GuessesComeFirstAndPolymersLast) {
  add_sample();
  const ResidueGroups found = groups();
  EXPECT_EQ(names(found), (Texts{"QQ1", "LYS", "HOH", "LYS.2"}));
  EXPECT_EQ(found.of[0].residues, 2u);
  EXPECT_EQ(found.of[0].atoms, 4u);
  EXPECT_EQ(found.of[3].residues, 2u);
  EXPECT_EQ(found.of[3].atoms, 18u);
  EXPECT_EQ(found.guessed, 2u);
  EXPECT_EQ(found.by_hand, 0u);
  EXPECT_EQ(kinds_text(found.kinds), "polymer 2 · water 1 · ligand 3") << "residues";
  EXPECT_EQ(decisions_text(found), "2 guessed");
  for (const ResidueGroup& group : found.of) {
    EXPECT_EQ(why_text(group), reason_text(group.why)) << "the words of the command line";
  }
}

TEST_F(ResidueGroupsTest, ANameIsUsedWhereNoOtherResidueHasIt) {
  add_sample();
  const ResidueGroups found = groups();
  EXPECT_EQ(found.of[0].called, Texts{"QQ1"});
  EXPECT_EQ(found.of[1].called, Texts{"A:LYS 301"});
  EXPECT_EQ(found.of[3].called, (Texts{"A:LYS 1", "A:LYS 2"}));
  EXPECT_EQ(selection_text(found.of[0]), "resn \"QQ1\"");
  EXPECT_EQ(selection_text(found.of[3]), "A:LYS 1,A:LYS 2");
}

TEST_F(ResidueGroupsTest, ATreatmentChangesItsLineAndMovesNone) {
  add_sample();
  Texts treatments;
  set_group_kind(treatments, groups().of[1], ResidueKind::ion);
  EXPECT_EQ(treatments, Texts{"A:LYS 301=ion"});
  set_group_kind(treatments, groups().of[0], ResidueKind::ligand);
  const ResidueGroups found = groups(treatments);
  EXPECT_EQ(names(found), names(groups()));
  EXPECT_EQ(found.of[1].kind, ResidueKind::ion);
  EXPECT_EQ(found.of[1].file_kind, ResidueKind::ligand);
  EXPECT_EQ(found.of[1].treated, Texts{"A:LYS 301=ion"});
  EXPECT_EQ(why_text(found.of[1]),
            std::string("set by hand; otherwise ligand (") + reason_text(Why::after_ter) + ")");
  EXPECT_EQ(found.of[3].kind, ResidueKind::polymer) << "of the same name";
  EXPECT_EQ(found.guessed, 0u) << "what is confirmed is no guess";
  EXPECT_EQ(found.by_hand, 3u);
  EXPECT_EQ(decisions_text(found), "3 set by hand");
  set_group_kind(treatments, found.of[1], ResidueKind::dummy);
  EXPECT_EQ(treatments, (Texts{"QQ1=ligand", "A:LYS 301=dummy"})) << "in place of the first";
  remove_treatments(treatments, groups(treatments).of[1]);
  EXPECT_EQ(treatments, Texts{"QQ1=ligand"});
}

TEST_F(ResidueGroupsTest, WhatIsTakenBackIsEveryTreatmentOfThem) {
  add_sample();
  Texts treatments{"LYS=ion", "resn HOH=ligand", "A:LYS 2=water"};
  const ResidueGroups found = groups(treatments);
  const auto of = [&](const char* name, ResidueKind kind) {
    return *std::find_if(found.of.begin(), found.of.end(), [&](const ResidueGroup& group) {
      return group.name == name && group.kind == kind;
    });
  };
  EXPECT_EQ(of("LYS", ResidueKind::water).treated, (Texts{"LYS=ion", "A:LYS 2=water"}));
  EXPECT_EQ(of("HOH", ResidueKind::ligand).treated, Texts{"resn HOH=ligand"})
      << "however it is named";
  remove_treatments(treatments, of("LYS", ResidueKind::water));
  EXPECT_EQ(treatments, Texts{"resn HOH=ligand"});
}

TEST_F(ResidueGroupsTest, ManyOfASharedNameAreNotNamedOneByOne) {
  const int most = static_cast<int>(kMostAddresses);
  for (int k = 0; k < most; ++k) add("GLY", k + 1, ResidueKind::polymer, Why::chain_bond);
  add("GLY", 900, ResidueKind::ligand, Why::hetatm);
  EXPECT_EQ(groups().of[1].called.size(), kMostAddresses);
  add("GLY", 800, ResidueKind::polymer, Why::chain_bond);
  EXPECT_EQ(groups().of[1].residues, kMostAddresses + 1);
  const std::string but_one = "resn \"GLY\" and not (chain \"A\" and resi 900)";
  EXPECT_EQ(groups().of[1].called, Texts{but_one});
  EXPECT_EQ(selection_text(groups().of[1]), but_one);
  Texts treatments;
  set_group_kind(treatments, groups().of[1], ResidueKind::dummy);
  const ResidueGroups treated = groups(treatments);
  ASSERT_EQ(treated.of.size(), 2u);
  EXPECT_EQ(treated.of[0].kind, ResidueKind::ligand) << "the one that was left out";
  EXPECT_EQ(treated.of[1].kind, ResidueKind::dummy);
  EXPECT_EQ(treated.of[1].residues, kMostAddresses + 1);
  EXPECT_EQ(treated.of[1].called, Texts{but_one}) << "the same words take it back";
  for (int k = 0; k < most; ++k) add("GLY", 1000 + k, ResidueKind::ligand, Why::hetatm);
  EXPECT_TRUE(groups().of[1].called.empty()) << "too many of both";
  EXPECT_EQ(selection_text(groups().of[1]), "");
}

TEST_F(ResidueGroupsTest, OthersAreLeftOutWithTheirInsertionCodes) {
  for (int k = 0; k <= static_cast<int>(kMostAddresses); ++k) {
    add("HOH", k + 1, ResidueKind::water, Why::water_name);
  }
  add("HOH", 7, ResidueKind::ligand, Why::hetatm);
  file_.atoms.back().insertion_code = 'B';
  add("HOH", -3, ResidueKind::ligand, Why::hetatm);
  Texts treatments;
  set_group_kind(treatments, groups().of[1], ResidueKind::ion);
  EXPECT_EQ(
      treatments,
      Texts{
          "resn \"HOH\" and not ((chain \"A\" and resi 7B) or (chain \"A\" and resi \"-3\"))=ion"});
  const ResidueGroups found = groups(treatments);
  ASSERT_EQ(found.of.size(), 2u);
  EXPECT_EQ(found.of[0].kind, ResidueKind::ligand);
  EXPECT_EQ(found.of[0].residues, 2u);
  EXPECT_EQ(found.of[1].residues, kMostAddresses + 1) << "residue 7 is not 7B";
}

TEST_F(ResidueGroupsTest, PointsWithoutMatterAreNeitherCountedNorTreated) {
  for (int k = 1; k <= 3; ++k) {
    add("TP4", k, ResidueKind::water, Why::water_name, 3);
    add("TP4", k, ResidueKind::dummy, Why::virtual_site);
  }
  const ResidueGroups found = groups({"TP4=ligand"});
  ASSERT_EQ(found.of.size(), 2u);
  const ResidueGroup& points = found.of[0];
  EXPECT_EQ(points.why, Why::virtual_site);
  EXPECT_TRUE(points.called.empty());
  EXPECT_TRUE(points.treated.empty());
  EXPECT_EQ(found.of[1].called, Texts{"TP4"}) << "the name means the waters";
  EXPECT_EQ(kinds_text(found.kinds), "ligand 3");
}

// Atoms of a chain without residues have no address of their own, since "A:" is the whole chain.
TEST_F(ResidueGroupsTest, WhatHasNoAddressIsNotNamed) {
  add("LIG", 1, ResidueKind::ligand, Why::hetatm);
  add("", 0, ResidueKind::polymer, Why::no_name);
  const ResidueGroups found = groups();
  ASSERT_EQ(found.of.size(), 2u);
  EXPECT_TRUE(found.of[0].called.empty());
}

TEST_F(ResidueGroupsTest, CopiesAreTreatedOneByOne) {
  add("LIG", 1, ResidueKind::ligand, Why::hetatm);
  Molecule assembly = file_;
  assembly.atoms.push_back(file_.atoms.front());
  assembly.atoms.back().chain = assembly.names.intern("A-2");
  assembly.copied = {{0, 2, {0}}};
  assembly.models = {{1, 0, 2}};
  const Texts treatments{"A-2:LIG 1=polymer"};
  const TreatedAtoms treated = apply_treatments(assembly, treatments);
  const ResidueGroups found = residue_groups(file_, assembly, 0, 2, treatments, treated);
  ASSERT_EQ(found.of.size(), 2u);
  EXPECT_EQ(found.of[0].called, Texts{"A-2:LIG 1"});
  EXPECT_EQ(found.of[0].file_kind, ResidueKind::ligand);
  EXPECT_EQ(found.of[0].file_why, Why::hetatm);
  EXPECT_EQ(found.of[1].called, Texts{"A:LIG 1"});
}

TEST_F(ResidueGroupsTest, FormatsWithoutResiduesHaveNone) {
  add("", 0, ResidueKind::polymer, Why::none, 5);
  EXPECT_TRUE(groups().of.empty());
}

}  // namespace
}  // namespace alphascope
