// SPDX-License-Identifier: GPL-3.0-or-later
// Tests secondary structure by records and by hydrogen bonds, and the backbones it needs.
#include "core/secondary/secondary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/molecule/assembly.hpp"
#include "core/secondary/hydrogen_bonds.hpp"
#include "core/secondary/ladders.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

Molecule crambin() {
  return read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) /
                       "resources/molecules/1crn.pdb");
}

std::string letters(const SecondaryModel& secondary) {
  std::string text;
  for (const SecondaryStructure kind : secondary.kinds) text += secondary_code(kind);
  return text;
}

// One ATOM line. Å.
std::string atom(int serial, const char* name, const char* residue, char chain, int number,
                 double x, double y, double z, char altloc = ' ') {
  char line[100];
  std::snprintf(line, sizeof line,
                "ATOM  %5d  %-3s%c%3s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00           %c\n", serial,
                name, altloc, residue, chain, number, x, y, z, name[0]);
  return line;
}

// N, CA, C and O of residues, 3.8 Å apart along x, with peptide bonds of 1.33 Å.
std::string strand(char chain, int first, int count, double y, const char* residue = "ALA") {
  std::string text;
  for (int k = 0; k < count; ++k) {
    const double x = 3.8 * k;
    text += atom(1, "N", residue, chain, first + k, x, y, 0);
    text += atom(2, "CA", residue, chain, first + k, x + 1.2, y + 0.8, 0);
    text += atom(3, "C", residue, chain, first + k, x + 2.47, y, 0);
    text += atom(4, "O", residue, chain, first + k, x + 2.47, y - 1.2, 0);
  }
  return text;
}

TEST(Secondary, CrambinHasTheRecordsOfItsFile) {
  const Molecule m = crambin();
  const SecondaryModel file = find_secondary(m, m.models.front());
  EXPECT_EQ(file.source, SecondarySource::file);
  EXPECT_EQ(letters(file), "EEEE  HHHHHHHHHHHHH   HHHHHHHH EEEE           ");
  EXPECT_EQ(summary(file), "2 helices (2 alpha), 2 strands; from the file's records");
}

// The letters of mkdssp 4.2.2 for 1CRN.
TEST(Secondary, CrambinHasTheLettersOfDssp) {
  const Molecule m = crambin();
  const SecondaryModel dssp = find_secondary(m, m.models.front(), SecondaryChoice::hydrogen_bonds);
  EXPECT_EQ(dssp.source, SecondarySource::hydrogen_bonds);
  EXPECT_EQ(letters(dssp), " EE SSHHHHHHHHHHHTTT  HHHHHHHHS EE SSS   GGG  ");
  EXPECT_EQ(dssp.residues.size(), 46u);
  EXPECT_EQ(dssp.incomplete, 0u);
}

TEST(Secondary, EnergyIsThatOfFourCharges) {
  // A group N-H ... O=C in one line: N at 0, H at 1, O at 2.9, C at 4.13 Å. The residue before the
  // donor has its C and O so that H lies at x = 1.
  std::string text;
  text += atom(1, "N", "GLY", 'A', 1, -3.0, 1.5, 0) + atom(2, "CA", "GLY", 'A', 1, -2.0, 2.0, 0) +
          atom(3, "C", "GLY", 'A', 1, -0.5, 1.2, 0) + atom(4, "O", "GLY", 'A', 1, -1.5, 1.2, 0);
  text += atom(5, "N", "GLY", 'A', 2, 0, 0, 0) + atom(6, "CA", "GLY", 'A', 2, -0.6, -1.3, 0) +
          atom(7, "C", "GLY", 'A', 2, -2.0, -1.2, 0) + atom(8, "O", "GLY", 'A', 2, -2.5, -2.2, 0);
  text += atom(9, "N", "GLY", 'B', 1, 4.6, 2.4, 0) + atom(10, "CA", "GLY", 'B', 1, 4.8, 1.2, 0) +
          atom(11, "C", "GLY", 'B', 1, 4.13, 0, 0) + atom(12, "O", "GLY", 'B', 1, 2.9, 0, 0);
  const Molecule m = read_text("a.pdb", text);
  const std::vector<BackboneResidue> residues =
      find_backbone(m, copy_units(m, m.models.front()).front());
  ASSERT_EQ(residues.size(), 3u);
  ASSERT_TRUE(residues[0].bound_to_next);
  const HydrogenBondList list = find_hydrogen_bonds(m, residues, {});
  const double expected = 27.888 * (1 / 2.9 + 1 / 3.13 - 1 / 1.9 - 1 / 4.13);
  ASSERT_EQ(list.of_donor[1].acceptor[0], 2u);
  EXPECT_NEAR(list.of_donor[1].energy_kilocalories_per_mole[0], expected, 0.0006);
}

TEST(Secondary, ProlineGivesNoHydrogenBond) {
  const Molecule m = read_text("a.pdb", strand('A', 1, 3, 0, "PRO") + strand('B', 1, 3, 2.9));
  const std::vector<BackboneResidue> residues =
      find_backbone(m, copy_units(m, m.models.front()).front());
  const HydrogenBondList list = find_hydrogen_bonds(m, residues, {});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(residues[k].ring_at_nitrogen);
    EXPECT_EQ(list.of_donor[k].acceptor[0], HydrogenBonds::kNone) << k;
  }
}

// Residues 2 and 12 of two strands, bonded as in an antiparallel pair; then 3 and 11.
std::vector<HydrogenBonds> bonds_of(std::size_t size,
                                    std::initializer_list<std::pair<int, int>> list) {
  std::vector<HydrogenBonds> bonds(size);
  for (const auto& [donor, acceptor] : list) {
    auto& of = bonds[static_cast<std::size_t>(donor)];
    of.acceptor[of.acceptor[0] == HydrogenBonds::kNone ? 0 : 1] =
        static_cast<std::uint32_t>(acceptor);
  }
  return bonds;
}

TEST(Secondary, AntiparallelPairsMakeALadder) {
  const std::vector<int> one_chain(20, 0);
  // N-H of 3 to O of 13 and back is a bridge of 3 and 13; those of 5 and 11 as well. Between them 4
  // and 12 are a bridge by the same bonds.
  const auto bonds = bonds_of(20, {{3, 13}, {13, 3}, {5, 11}, {11, 5}});
  const std::vector<Ladder> ladders = find_ladders(bonds, one_chain);
  ASSERT_EQ(ladders.size(), 1u);
  EXPECT_FALSE(ladders[0].parallel);
  EXPECT_EQ(ladders[0].i_first, 3);
  EXPECT_EQ(ladders[0].i_last, 5);
  EXPECT_EQ(ladders[0].j_first, 11);
  EXPECT_EQ(ladders[0].j_last, 13);
  // A break of the chain at 12 takes all but one pair away.
  std::vector<int> broken(20, 0);
  std::fill(broken.begin() + 12, broken.end(), 1);
  for (const Ladder& ladder : find_ladders(bonds, broken)) {
    EXPECT_TRUE(ladder.j_last < 11 || ladder.j_first > 12);
  }
}

TEST(Secondary, ABulgeJoinsTwoLadders) {
  const std::vector<int> one_chain(40, 0);
  // Two bridges, at (3, 23) and (5, 19): one residue between on one side, three on the other.
  const auto joined = find_ladders(bonds_of(40, {{3, 23}, {23, 3}, {5, 19}, {19, 5}}), one_chain);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].bridges, 2);
  // Five residues between on the longer side are too many.
  EXPECT_EQ(find_ladders(bonds_of(40, {{3, 23}, {23, 3}, {5, 17}, {17, 5}}), one_chain).size(), 2u);
}

TEST(Secondary, ChainBreaksAndMissingAtoms) {
  std::string text = strand('A', 1, 3, 0);
  text += atom(20, "CA", "GLY", 'A', 4, 12.6, 0.8, 0);  // CA alone, 3.8 Å behind
  text += strand('A', 9, 2, 40);                        // a gap
  text += strand('B', 1, 1, 60);
  const Molecule m = read_text("a.pdb", text);
  const SecondaryModel found = find_secondary(m, m.models.front());
  ASSERT_EQ(found.residues.size(), 7u);
  EXPECT_EQ(found.incomplete, 1u);
  const bool bound[] = {true, true, true, false, true, false, false};
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(found.residues[k].bound_to_next, bound[k]) << k;
}

TEST(Secondary, InsertionCodesAndAlternativeLocations) {
  std::string text = strand('A', 7, 1, 0);
  std::string inserted = strand('A', 7, 2, 0).substr(text.size());
  for (std::size_t line = 0; line < inserted.size(); line += text.size() / 4) {
    inserted.replace(line + 22, 5, "   7A");
  }
  text += inserted;
  // CA of residue 8 has two locations; B has the higher occupancy.
  std::string third = strand('A', 6, 3, 0).substr(2 * strand('A', 7, 1, 0).size());
  const std::size_t width = third.size() / 4;
  std::string a = third.substr(width, width), b = a;
  a[16] = 'A';
  a.replace(56, 4, "0.30");
  b[16] = 'B';
  b.replace(56, 4, "0.70");
  text += third.substr(0, width) + a + b + third.substr(2 * width);
  const Molecule m = read_text("a.pdb", text);
  const SecondaryModel found = find_secondary(m, m.models.front());
  ASSERT_EQ(found.residues.size(), 3u);
  EXPECT_EQ(m.atoms[found.residues[1].ca].insertion_code, 'A');
  EXPECT_EQ(m.atoms[found.residues[2].ca].altloc, 'B');
  EXPECT_TRUE(found.residues[0].bound_to_next && found.residues[1].bound_to_next);
}

TEST(Secondary, AResidueThatBeginsAnewIsNotTheSame) {
  // Two residues of one number: names of atoms come again.
  const Molecule m = read_text("a.pdb", strand('A', 1, 1, 0) + strand('A', 1, 1, 30));
  EXPECT_EQ(find_secondary(m, m.models.front()).residues.size(), 2u);
}

TEST(Secondary, WaterAndNucleicAcidsHaveNone) {
  const Molecule m = read_text("a.pdb",
                               "HETATM    1  O   HOH A   1       0.000   0.000   0.000\n"
                               "HETATM    2 CA    CA A   2       5.000   0.000   0.000\n");
  const SecondaryModel found = find_secondary(m, m.models.front());
  EXPECT_EQ(found.source, SecondarySource::none);
  EXPECT_TRUE(found.residues.empty());
  EXPECT_EQ(summary(found), "");
}

TEST(Secondary, CopiesOfAnAssemblyHaveTheKindsOfTheFirst) {
  std::string text =
      "REMARK 350 BIOMOLECULE: 1\n"
      "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A, B\n"
      "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
      "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000      100.00000\n"
      "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
      "SHEET    1   A 1 ALA B   2  ALA B   4  0\n";
  text += strand('A', 1, 4, 0) + strand('B', 1, 4, 30);
  const Molecule m = expand_assembly(read_text("a.pdb", text), "1");
  const SecondaryModel found = find_secondary(m, m.models.front());
  EXPECT_EQ(found.source, SecondarySource::file);
  EXPECT_EQ(letters(found), "     EEE     EEE");
  ASSERT_EQ(found.residues.size(), 16u);
  EXPECT_EQ(m.text(m.atoms[found.residues[13].ca].chain), "B-2");
  EXPECT_EQ(m.atoms[found.residues[13].ca].residue_number, 2);
  EXPECT_EQ(m.text(m.atoms[found.residues[13].o].name), "O");
  EXPECT_EQ(found.runs[static_cast<std::size_t>(SecondaryStructure::strand)], 2u);
}

TEST(Secondary, ManyResiduesAtOnePlaceTakeLinearTime) {
  std::string text;
  for (int k = 0; k < 6000; ++k) {
    const char chain = static_cast<char>('A' + k % 26);
    text += strand(chain, k % 9999 + 1, 1, 0.001 * (k % 100));
  }
  const Molecule m = read_text("a.pdb", text);
  const SecondaryModel found = find_secondary(m, m.models.front(), SecondaryChoice::hydrogen_bonds);
  EXPECT_EQ(found.residues.size(), 6000u);
  EXPECT_GT(found.crowded, 0u);
  EXPECT_NE(summary(found).find("too many others"), std::string::npos);
}

TEST(Secondary, Cancels) {
  const Molecule m = crambin();
  const RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(find_secondary(m, m.models.front(), SecondaryChoice::hydrogen_bonds, context),
               Cancelled);
}

}  // namespace
}  // namespace alphascope
