// SPDX-License-Identifier: GPL-3.0-or-later
// Tests mmCIF files.
#include <string>

#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

const std::string kTable =
    "data_TEST\n_struct.title 'Two of them'\nloop_\n_atom_site.group_PDB\n_atom_site.id\n"
    "_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.auth_asym_id\n"
    "_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_model_num\n";

TEST(ReadMmcif, KeepsDigitsNamesAndLines) {
  const Molecule m = read_text("a.cif", kTable +
                                            "ATOM 1 C \"C5'\" . DT A 1 1.00012 -2.5(3) 3 B 17 1\n"
                                            "HETATM 2 FE FE A HEM C . 1e1\n2 3 B 18 1\n");
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.format, "mmCIF");
  EXPECT_EQ(m.title, "Two of them");
  EXPECT_EQ(m.lattice.digits, 5);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{100012, -250000, 300000}));
  EXPECT_EQ(m.text(m.atoms[0].name), "C5'");
  EXPECT_EQ(m.text(m.atoms[0].chain), "B");
  EXPECT_EQ(m.text(m.atoms[0].label_chain), "A");
  EXPECT_EQ(m.atoms[0].residue_number, 17);
  EXPECT_EQ(m.atoms[0].source_line, 18u);
  EXPECT_EQ(m.atoms[1].position.x, 1000000);
  EXPECT_EQ(m.atoms[1].kind, ResidueKind::ligand);
  EXPECT_EQ(m.atoms[1].altloc, 'A');
  EXPECT_EQ(m.atoms[1].element, 26);
}

TEST(ReadMmcif, NamesTheLineOfWhatIsWrong) {
  const std::string row = "ATOM 1 C CA . ALA A 1 1.0 2.0 3.0 A 1 1\n";
  const ReadError nan =
      refusal("a.cif", kTable + row + "ATOM 2 C CB . ALA A 1 1.0 nan 3.0 A 1 1\n");
  EXPECT_EQ(nan.line(), 19u);
  EXPECT_EQ(nan.reason(), "expected a number for Cartn_y, found \"nan\"");
  EXPECT_EQ(refusal("a.cif", kTable + row + "ATOM 2 C CB . ALA A 1 ? 2 3.0 A 1 1\n").reason(),
            "Cartn_x has no value (?)");
  const ReadError cut = refusal("a.cif", kTable + row + "ATOM 2 C CB . ALA A 1 1.0\n");
  EXPECT_EQ(cut.reason(), "this row of the atom_site table has 9 of its 14 values");
  EXPECT_EQ(cut.line(), 19u);
  EXPECT_EQ(refusal("a.cif", kTable + row + "ATOM 2 C 'CB\n").line(), 19u);
  EXPECT_NE(refusal("a.cif", "data_X\n_atom_site_fract_x 1\n").reason().find("fractional"),
            std::string::npos);
  EXPECT_NE(refusal("a.cif", "data_X\n_entry.id X\n").reason().find("no atoms"), std::string::npos);
  EXPECT_NE(refusal("a.cif", kTable + row + "ATOM 2 C CB . ALA A 1 1 2 3 A 1 2\n" + row)
                .reason()
                .find("model 1 are not together"),
            std::string::npos);
}

TEST(ReadMmcif, ASecondTableHasColumnsOfItsOwn) {
  const std::string first =
      "loop_\n_atom_site.type_symbol\n_atom_site.auth_asym_id\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "C B 1 2 3\n";
  const Molecule m =
      read_text("a.cif", "data_X\n" + first +
                             "loop_\n_atom_site.Cartn_z\n_atom_site.Cartn_x\n"
                             "_atom_site.Cartn_y\n_atom_site.type_symbol\n6 4 5 N\n");
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.text(m.atoms[0].chain), "B");
  EXPECT_EQ(m.text(m.atoms[1].chain), "") << "not what is in the second column";
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{4000, 5000, 6000}));
  EXPECT_EQ(m.atoms[1].element, 7);
  EXPECT_EQ(refusal("a.cif", "data_X\n" + first +
                                 "loop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                                 "_atom_site.occupancy\n_atom_site.id\n_atom_site.type_symbol\n"
                                 "1 2 1 2 C\n")
                .reason(),
            "the atom_site table has no column Cartn_z");
}

TEST(ReadMmcif, TwinsInPdbGiveTheSameBalls) {
  ALPHASCOPE_NEED_TEST_DATA();
  const char* const twins[][2] = {{"thesis/4hhb.pdb.gz", "thesis/4hhb.cif.gz"},
                                  {"ladder/1crn.pdb", "ladder/1crn.cif"},
                                  {"ladder/1ubq.pdb", "ladder/1ubq.cif"},
                                  {"ladder/3sn6.pdb.gz", "ladder/3sn6.cif.gz"},
                                  {"ensembles/1d3z.pdb.gz", "ensembles/1d3z.cif.gz"},
                                  {"ladder/1m4x.pdb.gz", "ladder/1m4x.cif.gz"}};
  for (const auto& twin : twins) {
    const Molecule pdb = read_molecule(test_data(twin[0])), cif = read_molecule(test_data(twin[1]));
    EXPECT_EQ(pdb.models.size(), cif.models.size()) << twin[0];
    const PreparedBalls a = prepare_balls(pdb), b = prepare_balls(cif);
    EXPECT_EQ(a.balls->lattice, b.balls->lattice) << twin[0];
    EXPECT_EQ(a.balls->centres, b.balls->centres) << twin[0];
    EXPECT_EQ(a.balls->radii, b.balls->radii) << twin[0];
    EXPECT_EQ(summary(a.report), summary(b.report)) << twin[0];
  }
}

TEST(ReadMmcif, ReadsMinimalTables) {
  ALPHASCOPE_NEED_TEST_DATA();
  EXPECT_EQ(read_molecule(test_data("ladder/1xnr.cif.gz")).atoms.size(), 43833u);
  EXPECT_EQ(read_molecule(test_data("ladder/1gid.cif.gz")).atoms.size(), 4612u);
  EXPECT_EQ(read_molecule(test_data("awkward/sia-alt-id.cif")).atoms.size(), 20u);
}

}  // namespace
}  // namespace alphascope
