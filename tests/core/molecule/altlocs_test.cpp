// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the choice of alternative locations.
#include "core/molecule/altlocs.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

Atom atom(Molecule& m, const char* residue, const char* name, char altloc, float occupancy,
          float b) {
  Atom a;
  a.residue_name = m.names.intern(residue);
  a.name = m.names.intern(name);
  a.altloc = altloc;
  a.occupancy = occupancy;
  a.b_factor = b;
  a.residue_number = 7;
  return a;
}

std::vector<int> kept(const Molecule& m) {
  const std::vector<bool> minor = minor_altlocs(m, 0, m.atoms.size());
  std::vector<int> result;
  for (std::size_t i = 0; i < minor.size(); ++i) {
    if (!minor[i]) result.push_back(static_cast<int>(i));
  }
  return result;
}

TEST(Altlocs, OccupancyThenBFactorThenLetter) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", 'A', 0.4f, 1), atom(m, "SER", "CB", 'B', 0.6f, 9)};
  EXPECT_EQ(kept(m), std::vector<int>{1});
  m.atoms = {atom(m, "SER", "CB", 'A', 0.5f, 9), atom(m, "SER", "CB", 'B', 0.5f, 1)};
  EXPECT_EQ(kept(m), std::vector<int>{1});
  m.atoms = {atom(m, "SER", "CB", 'B', 0.5f, 1), atom(m, "SER", "CB", 'A', 0.5f, 1)};
  EXPECT_EQ(kept(m), std::vector<int>{1});
}

TEST(Altlocs, OneLetterPerResidueSoThatConformersDoNotMix) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CA", ' ', 1, 1),     atom(m, "SER", "CB", 'A', 0.6f, 1),
             atom(m, "SER", "CB", 'B', 0.4f, 1),  atom(m, "SER", "OG", 'A', 0.45f, 1),
             atom(m, "SER", "OG", 'B', 0.55f, 1), atom(m, "SER", "HG", 'B', 0.5f, 1)};
  // A has the higher mean occupancy. HG exists in B only and stays.
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 3, 5}));
}

TEST(Altlocs, AnotherResidueTypeGoesWithItsLetter) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", 'A', 0.6f, 1), atom(m, "SER", "OG", 'A', 0.6f, 1),
             atom(m, "THR", "CB", 'B', 0.4f, 1), atom(m, "THR", "CG2", 'B', 0.4f, 1)};
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1}));
}

TEST(Altlocs, BlankCompetesWithALetterOfTheSameName) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", ' ', 0.3f, 1), atom(m, "SER", "CB", 'B', 0.7f, 1),
             atom(m, "SER", "CA", ' ', 1, 1), atom(m, "SER", "CA", ' ', 1, 1)};
  // Two blank CA are a fault of the file, not alternatives. Both stay and are reported as
  // coincident.
  EXPECT_EQ(kept(m), (std::vector<int>{1, 2, 3}));
}

void renumber(Molecule& m, std::size_t from, int number) {
  for (std::size_t i = from; i < m.atoms.size(); ++i) m.atoms[i].residue_number = number;
}

TEST(Altlocs, LocationsMayStandBehindTheChain) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CA", ' ', 1, 1), atom(m, "SER", "CB", 'A', 0.6f, 1),
             atom(m, "GLY", "CA", ' ', 1, 1), atom(m, "SER", "CB", 'B', 0.4f, 1)};
  m.atoms[2].residue_number = 8;
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 2}));
}

TEST(Altlocs, AWaterWithAWrappedNumberIsNoLocationOfAnother) {
  Molecule m;
  m.atoms = {atom(m, "HOH", "O", ' ', 1, 1), atom(m, "HOH", "O", ' ', 1, 1),
             atom(m, "HOH", "O", 'A', 0.6f, 1), atom(m, "HOH", "O", 'B', 0.4f, 1)};
  renumber(m, 1, 9999);
  renumber(m, 2, 7);
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 2}));
  // Each has one letter, like a water beside one of two side chains.
  m.atoms = {atom(m, "HOH", "O", 'A', 0.5f, 1), atom(m, "HOH", "O", ' ', 1, 1),
             atom(m, "HOH", "O", 'B', 0.6f, 1)};
  m.atoms[1].residue_number = 9999;
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 2}));
  m.atoms[1].residue_number = 8;
  EXPECT_EQ(kept(m), (std::vector<int>{1, 2})) << "no new round of numbers between them";
}

TEST(Altlocs, AnotherSegmentsResidueIsAnotherResidue) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", 'A', 0.6f, 1), atom(m, "SER", "CB", 'B', 0.4f, 1),
             atom(m, "SER", "CB", ' ', 0.3f, 1), atom(m, "SER", "CB", 'C', 0.9f, 1)};
  EXPECT_EQ(kept(m), (std::vector<int>{3}));
  m.atoms[2].segment = m.atoms[3].segment = 1;
  EXPECT_EQ(kept(m), (std::vector<int>{0, 3}));
}

TEST(Altlocs, ResiduesWithoutSegmentsAreToldApartByWhatTheyHaveTwice) {
  Molecule m;
  // Two chains without a letter, first far apart, then adjacent.
  m.atoms = {atom(m, "SER", "CA", ' ', 1, 1),    atom(m, "SER", "CB", 'A', 0.6f, 1),
             atom(m, "SER", "CB", 'B', 0.4f, 1), atom(m, "GLY", "CA", ' ', 1, 1),
             atom(m, "SER", "CA", ' ', 1, 1),    atom(m, "SER", "CB", ' ', 1, 1)};
  m.atoms[3].residue_number = 8;
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 3, 4, 5}));
  m.atoms = {atom(m, "THR", "CA", ' ', 1, 1), atom(m, "THR", "CB", ' ', 1, 1),
             atom(m, "SER", "CA", ' ', 1, 1), atom(m, "SER", "CB", 'A', 0.6f, 1),
             atom(m, "SER", "CB", 'B', 0.4f, 1)};
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 2, 3}));
  // A ligand and a side chain with equal numbers and letters.
  m.atoms = {atom(m, "SER", "CB", 'A', 0.6f, 1), atom(m, "SER", "CB", 'B', 0.4f, 1),
             atom(m, "LIG", "C1", 'A', 0.6f, 1), atom(m, "LIG", "C1", 'B', 0.4f, 1)};
  EXPECT_EQ(kept(m), (std::vector<int>{0, 2}));
}

TEST(Altlocs, TypesMayAlternateAtomByAtom) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CA", 'A', 0.6f, 1), atom(m, "THR", "CA", 'B', 0.4f, 1),
             atom(m, "SER", "CB", 'A', 0.6f, 1), atom(m, "THR", "CB", 'B', 0.4f, 1),
             atom(m, "THR", "CG2", 'B', 0.4f, 1)};
  EXPECT_EQ(kept(m), (std::vector<int>{0, 2}));
}

TEST(Altlocs, AFileWithOneNumberForAllIsReadInLinearTime) {
  Molecule m;
  for (int i = 0; i < 200'000; ++i) {
    m.atoms.push_back(atom(m, "LIG", ("C" + std::to_string(i)).c_str(), i % 2 ? 'A' : ' ', 1, 1));
  }
  EXPECT_EQ(kept(m).size(), 200'000u);
  for (Atom& a : m.atoms) a.name = m.atoms[0].name;
  for (std::size_t i = 0; i < m.atoms.size(); i += 2) m.atoms[i].altloc = 'B';
  EXPECT_EQ(kept(m).size(), 100'000u);
}

}  // namespace
}  // namespace alphascope
