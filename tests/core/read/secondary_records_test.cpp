// SPDX-License-Identifier: GPL-3.0-or-later
// Tests records of helices and strands, and bonds that a file states, as atoms of the molecule.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/core/read/residue_dialects.hpp"

namespace alphascope {
namespace {

using Kind = SecondaryStructure;

// Ten residues of chain A, four atoms each, and three of chain B.
std::vector<SampleAtom> two_chains() {
  std::vector<SampleAtom> sample;
  for (int k = 0; k < 10; ++k) add_amino_acid(sample, "ALA", 'A', k + 1, 3.8 * k, 0);
  for (int k = 0; k < 3; ++k) add_amino_acid(sample, "GLY", 'B', k + 1, 3.8 * k, 30);
  return sample;
}

std::string helix(char chain, const char* first, char last_chain, const char* last,
                  const char* kind = " 1") {
  return text_of("HELIX    1   1 ALA %c %4s  ALA %c %4s %2s", chain, first, last_chain, last,
                 kind) +
         "                                   9\n";
}
std::string sheet(const char* first, const char* last) {
  return text_of("SHEET    1   A 2 ALA A%4s  ALA A%4s  0\n", first, last);
}

bool notes_contain(const Molecule& m, const std::string& text) {
  return std::any_of(m.notes.begin(), m.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(SecondaryRecords, OfPdbFiles) {
  const Molecule m = read_text(
      "a.pdb", helix('A', "2", 'A', "4") + helix('A', "5", 'A', "6", " 5") +
                   helix('B', "1", 'B', "3", " 3") + sheet("8", "9") + as_pdb(two_chains()));
  const std::vector<SecondaryRange> expected = {{4, 16, Kind::alpha_helix},
                                                {16, 24, Kind::three_ten_helix},
                                                {40, 52, Kind::pi_helix},
                                                {28, 36, Kind::strand}};
  EXPECT_EQ(m.stated_secondary, expected);
  EXPECT_FALSE(notes_contain(m, "helices"));
}

TEST(SecondaryRecords, OfMmcif) {
  const std::string tables =
      "loop_\n_struct_conf.conf_type_id\n_struct_conf.beg_auth_asym_id\n"
      "_struct_conf.beg_auth_seq_id\n_struct_conf.pdbx_beg_PDB_ins_code\n"
      "_struct_conf.end_auth_asym_id\n_struct_conf.end_auth_seq_id\n"
      "_struct_conf.pdbx_PDB_helix_class\n"
      "HELX_P A 2 ? A 4 1\nHELX_P A 5 ? A 6 5\nTURN_P A 7 ? A 7 ?\nOTHER A 8 ? A 8 ?\n"
      "_struct_sheet_range.sheet_id A\n_struct_sheet_range.beg_auth_asym_id A\n"
      "_struct_sheet_range.beg_auth_seq_id 8\n_struct_sheet_range.end_auth_asym_id A\n"
      "_struct_sheet_range.end_auth_seq_id 9\n";
  const Molecule m = read_text("a.cif", as_mmcif(two_chains(), {}) + tables);
  const std::vector<SecondaryRange> expected = {{4, 16, Kind::alpha_helix},
                                                {16, 24, Kind::three_ten_helix},
                                                {24, 28, Kind::turn},
                                                {28, 36, Kind::strand}};
  EXPECT_EQ(m.stated_secondary, expected);
}

TEST(SecondaryRecords, BadOnesAreCountedAndLeftOut) {
  const std::string records = helix('A', "2", 'A', "44") +  // line 1: no residue 44
                              helix('A', "6", 'A', "3") +   // line 2: inverted
                              helix('A', "6", 'B', "2") +   // line 3: two chains
                              helix('Q', "1", 'Q', "2") +   // line 4: no chain Q
                              helix('A', "****", 'A', "3") + sheet("", "") +  // lines 5 and 6
                              helix('A', "9999", 'A', "-999") + "HELIX \nSHEET \nHELIX    1\n";
  const Molecule m = read_text("a.pdb", records + as_pdb(two_chains()));
  EXPECT_TRUE(m.stated_secondary.empty());
  EXPECT_TRUE(notes_contain(m, "residues that are not in the file: 8 (lines 1, 4, 5, 6, 7 …)"));
  EXPECT_TRUE(notes_contain(m, "they end before they begin: 1 (line 2)"));
  EXPECT_TRUE(notes_contain(m, "different chains or on both sides of another chain: 1 (line 3)"));
}

TEST(SecondaryRecords, HostileNumbersOfMmcif) {
  std::string tables =
      "loop_\n_struct_conf.conf_type_id\n_struct_conf.beg_auth_asym_id\n"
      "_struct_conf.beg_auth_seq_id\n_struct_conf.end_auth_asym_id\n_struct_conf.end_auth_seq_id\n";
  tables +=
      "HELX_P A 99999999999999999999 A 3\nHELX_P A 1 A -2147483649\nHELX_P A 1.5 A 3\n"
      "HELX_P ? ? ? ?\nHELX_P A 1 A 2\n";
  const Molecule m = read_text("a.cif", as_mmcif(two_chains(), {}) + tables);
  ASSERT_EQ(m.stated_secondary.size(), 1u);
  EXPECT_EQ(m.stated_secondary[0].end, 8u);
  EXPECT_TRUE(notes_contain(m, "residues that are not in the file: 4"));
}

TEST(SecondaryRecords, HoldForEachModelThatHasTheResidues) {
  const std::string atoms = as_pdb(two_chains());
  const std::string without_end = atoms.substr(0, atoms.size() - 4);
  const Molecule m =
      read_text("a.pdb", helix('B', "1", 'B', "3") + "MODEL        1\n" + without_end +
                             "ENDMDL\nMODEL        2\n" + without_end + "ENDMDL\n" +
                             "MODEL        3\n" + without_end.substr(0, 10 * 4 * 79) + "ENDMDL\n");
  ASSERT_EQ(m.models.size(), 3u);
  ASSERT_EQ(m.stated_secondary.size(), 2u);
  EXPECT_EQ(m.stated_secondary[1].begin, m.models[1].begin + 40);
  EXPECT_FALSE(notes_contain(m, "helices"));
}

Bond bond(std::uint32_t a, std::uint32_t b, BondOrder order = BondOrder::unknown,
          BondKind kind = BondKind::covalent) {
  return {a, b, order, kind, BondReason::file};
}

TEST(StatedBonds, OfPdbFiles) {
  const std::string atoms =
      "SSBOND   1 CYS A    1    CYS A    2                          1555   1555  2.03\n"
      "SSBOND   2 CYS A    1    CYS A    2                          1555   2555  2.03\n"
      "ATOM      1  SG  CYS A   1       0.000   0.000   0.000  1.00  0.00           S\n"
      "ATOM      2  SG ACYS A   2       2.000   0.000   0.000  0.50  0.00           S\n"
      "ATOM      3  SG BCYS A   2       2.000   0.300   0.000  0.50  0.00           S\n"
      "HETATM    4 ZN    ZN A   3       0.000   2.300   0.000  1.00  0.00          ZN\n"
      "HETATM    5  C1  LIG A   4       9.000   0.000   0.000  1.00  0.00           C\n"
      "HETATM    6  O1  LIG A   4      10.200   0.000   0.000  1.00  0.00           O\n"
      "CONECT    5    6    6\nCONECT    6    5    5\nCONECT    1    4\nCONECT    5   77\n"
      "CONECT    5    5\n";
  const Molecule m = read_text("a.pdb", atoms);
  const std::vector<Bond> expected = {bond(0, 1, BondOrder::one), bond(0, 2, BondOrder::one),
                                      bond(0, 3, BondOrder::unknown, BondKind::coordination),
                                      bond(4, 5, BondOrder::two)};
  EXPECT_EQ(m.stated_bonds, expected);
  EXPECT_EQ(m.unresolved_bonds, 2u);  // 77 is not there, and 5 is not bonded to itself
}

TEST(StatedBonds, OfMol2HaveOrders) {
  const Molecule m = read_text("a.mol2",
                               "@<TRIPOS>MOLECULE\nx\n 4 4\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n"
                               "1 C1 0 0 0 C.2\n2 O1 1.2 0 0 O.2\n3 N1 -1.3 0 0 N.am\n"
                               "4 C2 -2.6 0 0 C.ar\n@<TRIPOS>BOND\n1 1 2 2\n2 1 3 am\n3 3 4 ar\n"
                               "4 2 4 nc\n");
  const std::vector<Bond> expected = {bond(0, 1, BondOrder::two), bond(0, 2, BondOrder::one),
                                      bond(2, 3, BondOrder::aromatic)};
  EXPECT_EQ(m.stated_bonds, expected);
}

TEST(StatedBonds, OfMmcifLeaveHydrogenBondsOut) {
  std::string table = "loop_\n_struct_conn.id\n_struct_conn.conn_type_id\n";
  for (const char* partner : {"ptnr1", "ptnr2"}) {
    for (const char* column : {"auth_asym_id", "auth_seq_id", "label_atom_id"}) {
      table += std::string("_struct_conn.") + partner + "_" + column + "\n";
    }
  }
  table += "_struct_conn.pdbx_value_order\n";
  table +=
      "1 covale A 1 C A 3 N sing\n2 hydrog A 1 N A 4 O ?\n3 disulf A 2 CA A 5 CA ?\n"
      "4 metalc A 2 O A 6 O ?\n5 covale A 1 C A 77 N ?\n";
  const Molecule m = read_text("a.cif", as_mmcif(two_chains(), {}) + table);
  const std::vector<Bond> expected = {bond(2, 8, BondOrder::one), bond(5, 17, BondOrder::one),
                                      bond(7, 23)};
  EXPECT_EQ(m.stated_bonds, expected);
  EXPECT_EQ(m.unresolved_bonds, 1u);
}

std::string component_bonds(const std::string& rows) {
  return "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n"
         "_chem_comp_bond.value_order\n_chem_comp_bond.pdbx_aromatic_flag\n" +
         rows;
}

std::string ligand_atoms(const std::string& rows) {
  std::string table = "data_x\nloop_\n";
  for (const char* column :
       {"group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id", "label_comp_id",
        "auth_asym_id", "auth_seq_id", "Cartn_x", "Cartn_y", "Cartn_z"}) {
    table += std::string("_atom_site.") + column + "\n";
  }
  return table + rows;
}

TEST(StatedBonds, OfComponentsAreInEachResidue) {
  const Molecule m = read_text(
      "a.cif",
      ligand_atoms("HETATM 1 C C1 . LIG A 1 0 0 0\n"
                   "HETATM 2 O O1 A LIG A 1 1.2 0 0\n"
                   "HETATM 3 O O1 B LIG A 1 0 1.2 0\n"
                   "HETATM 4 C \"C1'\" . LIG A 1 0 0 1.4\n"
                   "HETATM 5 C C1 . LIG A 2 9 0 0\n"
                   "HETATM 6 C \"C1'\" . LIG A 2 9 0 1.4\n"
                   "HETATM 7 C C1 . LIG A 2 9 9 0\n"  // another residue, by the same number
                   "HETATM 8 O O1 . LIG A 2 9 9 1.2\n"
                   "ATOM 9 C CA . GLY A 3 0 0 9\n"
                   "ATOM 10 C C . GLY A 3 0 0 10.5\n") +
          "#\n" +
          component_bonds("LIG C1 O1 DOUB N\nLIG C1 \"C1'\" SING Y\nLIG C1 H1 SING N\n"
                          "GLY CA C SING N\nABC C1 O1 TRIP N\n"));
  const std::vector<Bond> expected = {bond(0, 1, BondOrder::two), bond(0, 2, BondOrder::two),
                                      bond(0, 3, BondOrder::aromatic),
                                      bond(4, 5, BondOrder::aromatic), bond(6, 7, BondOrder::two)};
  EXPECT_EQ(m.stated_bonds, expected);
  EXPECT_EQ(m.unresolved_bonds, 0u) << "hydrogens are often not in the file";
}

// A component without atom sites, after a block that lists components.
TEST(StatedBonds, OfAComponentFile) {
  const std::string atoms = "data_comp_list\n" + component_bonds("LIG C1 O1 TRIP N\n") +
                            "data_LIG\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n"
                            "_chem_comp_atom.type_symbol\n_chem_comp_atom.model_Cartn_x\n"
                            "_chem_comp_atom.model_Cartn_y\n_chem_comp_atom.model_Cartn_z\n"
                            "LIG C1 C 0 0 0\nLIG O1 O 1.2 0 0\n";
  const Molecule m = read_text("a.cif", atoms + component_bonds("LIG C1 O1 DOUB N\n"));
  EXPECT_EQ(m.stated_bonds, std::vector<Bond>{bond(0, 1, BondOrder::two)});
}

}  // namespace
}  // namespace alphascope
