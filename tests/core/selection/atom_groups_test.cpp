// SPDX-License-Identifier: GPL-3.0-or-later
// Tests groups of atoms, such as those of one residue or chain.
#include "core/selection/atom_groups.hpp"

#include <gtest/gtest.h>

#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

using Numbers = std::vector<std::uint32_t>;

Molecule some_molecule() {
  return read_text(
      "a.pdb",
      "ATOM      1  N   HIS A  87      27.340  24.430   2.614  1.00  9.67           N  \n"
      "ATOM      2  CA  HIS A  87      26.266  25.413   2.842  1.00 10.38           C  \n"
      "ATOM      3  N   GLY A  88      26.266  25.413  -2.842  1.00 10.38           N  \n"
      "ATOM      4  N   ALA B  88      26.266  29.413  -2.842  1.00 10.38           N  \n"
      "HETATM    5 ZN    ZN A  90       1.266  25.413   8.842  1.00 10.38          ZN  \n");
}

TEST(AtomGroups, AreAtomsResiduesOrChains) {
  const Molecule m = some_molecule();
  const Numbers all{0, 1, 2, 3, 4};
  EXPECT_EQ(atom_groups(m, all, AtomGrouping::atom).of_ball, all);
  const AtomGroups residues = atom_groups(m, all, AtomGrouping::residue);
  EXPECT_EQ(residues.of_ball, (Numbers{0, 0, 1, 2, 3}));
  EXPECT_EQ(residues.first, (Numbers{0, 2, 3, 4}));
  const AtomGroups chains = atom_groups(m, all, AtomGrouping::chain);
  EXPECT_EQ(chains.of_ball, (Numbers{0, 0, 0, 1, 0})) << "a chain has its ions, too";
  EXPECT_EQ(group_name(m, residues.first[1], AtomGrouping::residue), "A:GLY 88");
  EXPECT_EQ(group_name(m, chains.first[1], AtomGrouping::chain), "B");
  // Only atoms that are balls count, by their indices among the balls.
  EXPECT_EQ(atom_groups(m, Numbers{1, 3}, AtomGrouping::residue).first, (Numbers{1, 3}));
}

TEST(AtomGroups, AtomsWithoutNamesAreAlone) {
  const Molecule m = read_text("a.xyzr", "0 0 0 1\n1 0 0 1\n");
  EXPECT_EQ(atom_groups(m, Numbers{0, 1}, AtomGrouping::residue).of_ball, (Numbers{0, 1}));
}

}  // namespace
}  // namespace alphascope
