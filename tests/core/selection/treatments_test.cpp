// SPDX-License-Identifier: GPL-3.0-or-later
// Tests kinds of residues that a user sets.
#include "core/selection/treatments.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/molecule/residue_reason.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {
namespace {

// Two atoms each of LIG 1 and LIG 2 in chain A, and one of HOH 3.
Molecule small() {
  Molecule m;
  const NameId chain = m.names.intern("A"), lig = m.names.intern("LIG"),
               water = m.names.intern("HOH"), c = m.names.intern("C1");
  for (int i = 0; i < 5; ++i) {
    Atom atom;
    atom.chain = atom.label_chain = chain;
    atom.residue_name = i < 4 ? lig : water;
    atom.residue_number = i / 2 + 1;
    atom.name = c;
    atom.element = 6;
    atom.kind = i < 4 ? ResidueKind::ligand : ResidueKind::water;
    atom.why = i < 4 ? ResidueReason::no_polymer : ResidueReason::water_name;
    atom.position = {2000 * i, 0, 0};
    m.atoms.push_back(atom);
  }
  m.models.push_back({1, 0, 5});
  return m;
}

TEST(Treatments, AreReadAndWritten) {
  const Treatment t = parse_treatment(" A:PU8 301 = ligand");
  EXPECT_EQ(t.residues, "A:PU8 301");
  EXPECT_EQ(t.kind, ResidueKind::ligand);
  EXPECT_EQ(treatment_text(t), "A:PU8 301=ligand");
  for (const char* wrong :
       {"", "A:PU8 301", "=ligand", "LIG=metal", "LIG=", "resi (=ion", "A:LIG x=ion", "#0=ion"}) {
    EXPECT_THROW(parse_treatment(wrong), std::invalid_argument) << wrong;
  }
}

TEST(Treatments, GoByAddressNameAndExpression) {
  Molecule m = small();
  apply_treatments(m, {"LIG=polymer", "A:LIG 2=ion", "resn HOH=ligand"});
  EXPECT_EQ(m.atoms[0].kind, ResidueKind::polymer);
  EXPECT_EQ(m.atoms[1].why, ResidueReason::by_hand);
  EXPECT_EQ(m.atoms[2].kind, ResidueKind::ion) << "the later goes before the earlier";
  EXPECT_EQ(m.atoms[4].kind, ResidueKind::ligand);
  EXPECT_TRUE(m.notes.empty());
  apply_treatments(m, {"B:XYZ 7=water"});
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_EQ(m.notes[0], "Residues to be treated as water that are not in this file: B:XYZ 7");
}

TEST(Treatments, SettleWhatWasANoteOnGuesses) {
  const std::string note =
      std::string(guess_note(ResidueReason::no_polymer)) + ": 2 residues (A:LIG 1, A:LIG 2)";
  Molecule m = small();
  m.notes = {"Another note", note};
  apply_treatments(m, {"A:LIG 1=ligand"});
  EXPECT_EQ(m.notes, (std::vector<std::string>{"Another note",
                                               note + "; some of them are set by hand now"}));
  m = small();
  m.notes = {"Another note", note};
  apply_treatments(m, {"A:LIG 1=ligand", "A:LIG 2=polymer"});
  EXPECT_EQ(m.notes, std::vector<std::string>{"Another note"});
  m = small();
  m.notes = {note};
  apply_treatments(m, {"HOH=ligand"});
  EXPECT_EQ(m.notes, std::vector<std::string>{note});
}

// A list of treatments can serve many files, some of which lack such a residue.
TEST(Treatments, ANameThatIsNotThereFindsNothing) {
  for (const std::string name : {"PU8", "005", "C-1"}) {
    Molecule m = small();
    apply_treatments(m, {name + "=water"});
    EXPECT_EQ(m.atoms[0].kind, ResidueKind::ligand);
    ASSERT_EQ(m.notes.size(), 1u);
    EXPECT_EQ(m.notes[0], "Residues to be treated as water that are not in this file: " + name);
  }
}

TEST(Treatments, OneOfEachResidueIsKept) {
  std::vector<std::string> list{"A:LIG 1=polymer", "LIG=ion"};
  set_treatment(list, {"A:LIG 1", ResidueKind::water});
  EXPECT_EQ(list, (std::vector<std::string>{"LIG=ion", "A:LIG 1=water"}));
  reset_treatment(list, "LIG");
  EXPECT_EQ(list, std::vector<std::string>{"A:LIG 1=water"});
}

TEST(Treatments, GuessesAreCountedByResidueUntilTheyAreSet) {
  Molecule m = small();
  EXPECT_EQ(prepare_balls(m).report.guessed_residues, 2u);
  BallOptions one;
  one.selection = "resi 2";
  EXPECT_EQ(prepare_balls(m, one).report.guessed_residues, 1u) << "of the selection only";
  apply_treatments(m, {"LIG=ligand"});
  EXPECT_EQ(prepare_balls(m).report.guessed_residues, 0u);
}

}  // namespace
}  // namespace alphascope
