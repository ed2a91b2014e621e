// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the tree of residues: branches, letters, secondary structure, and the row of each atom.
#include "core/document/structure/structure_rows.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/read/read_molecule.hpp"
#include "core/run/cancel_token.hpp"
#include "core/secondary/secondary.hpp"

namespace alphascope {
namespace {

Molecule sample(const char* file) {
  return read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules" / file);
}

StructureRows rows_of(const Molecule& molecule) {
  return make_structure_rows(molecule, molecule.models.front(),
                             find_secondary_of_models(molecule, molecule.models.front()), {});
}

TEST(StructureRows, CrambinHasItsSequence) {
  const Molecule molecule = sample("1crn.pdb");
  const StructureRows rows = rows_of(molecule);
  ASSERT_EQ(rows.branches.size(), 1u);
  EXPECT_EQ(rows.branches[0].title, "Chain A");
  std::string letters, kinds;
  for (const ResidueRow& row : rows.residues) {
    letters += row.letter;
    kinds += is_helix(row.secondary)                       ? 'H'
             : row.secondary == SecondaryStructure::strand ? 'E'
                                                           : '-';
  }
  EXPECT_EQ(letters, "TTCCPSIVARSNFNVCRLPGTPEAICATYTGCIIIPGATCPGDYAN");  // PDB entry 1CRN
  EXPECT_EQ(kinds.substr(6, 13), "HHHHHHHHHHHHH");  // its first HELIX record: residues 7 to 19
  EXPECT_EQ(residue_title(molecule, rows.residues[1]), "THR 2");
}

TEST(StructureRows, LigandsAndWatersFollowTheChains) {
  const Molecule molecule = sample("4hhb.pdb.gz");
  const StructureRows rows = rows_of(molecule);
  ASSERT_EQ(rows.branches.size(), 6u);
  const char* const titles[] = {"Chain A", "Chain B", "Chain C", "Chain D", "Ligands", "Waters"};
  const std::size_t sizes[] = {141, 146, 141, 146, 6, 221};
  std::size_t begin = 0;
  for (std::size_t b = 0; b < 6; ++b) {
    EXPECT_EQ(rows.branches[b].title, titles[b]);
    EXPECT_EQ(rows.branches[b].size(), sizes[b]) << titles[b];
    EXPECT_EQ(rows.branches[b].begin, begin);
    begin = rows.branches[b].end;
  }
  EXPECT_EQ(begin, rows.residues.size());
  EXPECT_EQ(residue_title(molecule, rows.residues[rows.branches[0].begin]), "VAL 1");
  EXPECT_EQ(residue_title(molecule, rows.residues[rows.branches[4].begin]), "HEM 142, chain A");
}

TEST(StructureRows, EveryAtomHasItsRow) {
  const Molecule molecule = sample("4hhb.pdb.gz");
  const StructureRows rows = rows_of(molecule);
  for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) {
    const auto row = rows.row_of(i);
    ASSERT_TRUE(row) << i;
    EXPECT_LE(rows.residues[*row].first, i);
    EXPECT_GT(rows.residues[*row].end, i);
  }
  EXPECT_FALSE(rows.row_of(static_cast<std::uint32_t>(molecule.atoms.size())));
}

TEST(StructureRows, StopsWhenCancelled) {
  const Molecule molecule = sample("4hhb.pdb.gz");
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(make_structure_rows(molecule, molecule.models.front(), {}, context), Cancelled);
}

}  // namespace
}  // namespace alphascope
