// SPDX-License-Identifier: GPL-3.0-or-later
// Tests points that files list as atoms but that are none, element columns, and values in place of
// B factors.
#include <string>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/altlocs.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/read/residues/virtual_sites.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// name: columns 13-16; element: columns 77-78.
std::string pdb_atom(const std::string& name, const std::string& residue, double x,
                     const std::string& element = "", const std::string& record = "ATOM  ") {
  char line[128];
  std::snprintf(line, sizeof line,
                "%-6s    1 %-4s %-4sA   1    %8.3f   0.000   0.000  1.00 50.00          %2s\n",
                record.c_str(), name.c_str(), residue.c_str(), x, element.c_str());
  return line;
}

std::vector<ResidueKind> kinds(const Molecule& m) {
  std::vector<ResidueKind> result;
  for (const Atom& atom : m.atoms) result.push_back(atom.kind);
  return result;
}

bool is_noted(const Molecule& m, const std::string& words) {
  for (const std::string& note : m.notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(VirtualSites, OfWaters) {
  for (const char* site : {"EPW", "EP", " MW", "MW1", " M", " LP1", " EP2"}) {
    const Molecule m = read_text("a.pdb", pdb_atom(" O", "WAT", 0) + pdb_atom(" H1", "WAT", 1) +
                                              pdb_atom(site, "WAT", 0.15));
    EXPECT_EQ(kinds(m), (std::vector{ResidueKind::water, ResidueKind::water, ResidueKind::dummy}))
        << site;
    EXPECT_TRUE(is_noted(m, "1 of 3")) << site;
  }
}

TEST(VirtualSites, OfProteinsAndLigands) {
  const Molecule m =
      read_text("a.pdb", pdb_atom(" C1", "LIG", 0, "C") + pdb_atom(" V1", "LIG", 1, "VS") +
                             pdb_atom("MCH3", "ALA", 5) + pdb_atom("MNH1", "LYS", 9) +
                             pdb_atom(" QB", "ALA", 12) + pdb_atom("LPOA", "ALA", 15) +
                             pdb_atom(" DU", "LIG", 18) + pdb_atom(" X1", "LIG", 19, "X"));
  for (std::size_t k = 1; k < m.atoms.size(); ++k)
    EXPECT_EQ(m.atoms[k].kind, ResidueKind::dummy) << k;
  EXPECT_EQ(prepare_balls(m).balls->size(), 1u);
}

TEST(VirtualSites, AtomsOfSuchNamesAreAtoms) {
  // A stated element is accepted, and deuterium is hydrogen. An X in a known residue, or of an
  // unknown atom, is an atom of unknown element.
  const Molecule m = read_text(
      "a.pdb", pdb_atom("MW", "LIG", 0, "MG", "HETATM") + pdb_atom(" D1", "DOD", 4) +
                   pdb_atom(" D", "ALA", 8) + pdb_atom(" CA", "GLY", 12, "X") +
                   pdb_atom(" UNK", "UNX", 16, "X", "HETATM") + pdb_atom("VS1", "LIG", 20, "V") +
                   pdb_atom(" DU", "LIG", 24, "D") + pdb_atom(" AD1", "ASN", 28));
  for (std::size_t k = 0; k < m.atoms.size(); ++k)
    EXPECT_NE(m.atoms[k].kind, ResidueKind::dummy) << k;
  const Element expected[] = {12, 1, 1, 0, 0, 23, 1, 0};
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(m.atoms[k].element, expected[k]) << k;
}

TEST(VirtualSites, DrudeParticlesStandOnTheirAtoms) {
  const std::string card =
      "* T\n*\n    7\n"
      "    1    1 SWM4 OH2    1.00000   2.00000   3.00000 WAT  1      0.00000\n"
      "    2    1 SWM4 DOH2   1.00000   2.00000   3.01000 WAT  1      0.00000\n"
      "    3    1 SWM4 OM     1.10000   2.00000   3.00000 WAT  1      0.00000\n"
      "    4    1 SWM4 H1     1.95000   2.00000   3.00000 WAT  1      0.00000\n"
      "    5    2 ALA  CA     9.00000   2.00000   3.00000 PRO  2      0.00000\n"
      "    6    2 ALA  DCA    9.00000   2.00000   3.00000 PRO  2      0.00000\n"
      "    7    2 ALA  DB    12.00000   2.00000   3.00000 PRO  2      0.00000\n";
  const Molecule m = read_text("a.crd", card);
  const bool dummy[] = {false, true, true, false, false, true, false};
  for (std::size_t k = 0; k < 7; ++k)
    EXPECT_EQ(m.atoms[k].kind == ResidueKind::dummy, dummy[k]) << k;
  EXPECT_EQ(m.atoms[6].element, kHydrogen) << "deuterium, since no B is beside it";
}

// One residue of 30,000 carbons of one name in a row, and as many particles. Every second one is on
// a carbon. At the last carbon they are just within 0.5 Å and just beyond. Comparing all pairs
// would take 10^9 steps.
TEST(VirtualSites, OfAResidueOfManyAtomsAreFoundNearThem) {
  constexpr int kAtoms = 30000;
  std::vector<bool> is_site;
  Molecule m;
  m.lattice = Lattice{3};
  const NameId residue = m.names.intern("BIG"), carbon = m.names.intern("CA"),
               particle = m.names.intern("DCA");
  const auto add = [&](NameId name, std::int32_t x, std::int32_t z, bool site) {
    Atom atom;
    atom.name = name;
    atom.residue_name = residue;
    atom.residue_number = 1;
    atom.position = {x, 0, z};
    atom.element = 6;
    m.atoms.push_back(atom);
    is_site.push_back(site);
  };
  for (int k = 0; k < kAtoms; ++k) {
    add(carbon, 1500 * (k - kAtoms / 2), 0, false);
    // Half of the particles are in the middle between two carbons.
    add(particle, 1500 * (k - kAtoms / 2) + (k % 2 ? 750 : 100), 0, k % 2 == 0);
  }
  const std::int32_t last = 1500 * (kAtoms / 2 - 1);
  add(particle, last, 500, true);
  add(particle, last, -501, false);
  add(particle, last, -500, true);
  m.models.push_back({1, 0, m.atoms.size()});
  mark_sites_at_atoms(m);
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    ASSERT_EQ(m.atoms[i].kind == ResidueKind::dummy, is_site[i]) << i;
    ASSERT_EQ(m.atoms[i].element, is_site[i] ? kUnknownElement : Element{6}) << i;
  }
}

// A particle of another location or residue does not belong to this atom.
TEST(VirtualSites, StandOnAtomsOfTheirLocationAndResidue) {
  Molecule m;
  m.lattice = Lattice{3};
  const NameId residue = m.names.intern("BIG");
  const auto add = [&](const char* name, char altloc, int number) {
    Atom atom;
    atom.name = m.names.intern(name);
    atom.residue_name = residue;
    atom.residue_number = number;
    atom.altloc = altloc;
    m.atoms.push_back(atom);
  };
  add("CA", 'A', 1);
  add("DCA", 'A', 1);
  add("DCA", 'B', 1);
  add("DCB", 'A', 1);
  add("DCA", 'A', 2);
  m.models.push_back({1, 0, m.atoms.size()});
  mark_sites_at_atoms(m);
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    EXPECT_EQ(m.atoms[i].kind == ResidueKind::dummy, i == 1) << i;
  }
}

TEST(VirtualSites, AlphaSpheresOfFpocket) {
  const Molecule m = read_text("a.pdb", pdb_atom(" CA", "ALA", 0, "C") +
                                            pdb_atom("APOL", "STP", 5, "Ve", "HETATM") +
                                            pdb_atom(" POL", "STP", 9, "Ve", "HETATM"));
  EXPECT_EQ(prepare_balls(m).atom_of_ball, (std::vector<std::uint32_t>{0}));
}

TEST(VirtualSites, AFileOfNothingElseKeepsThem) {
  const Molecule m =
      read_text("a.pdb", pdb_atom(" B1", "BEA", 0, "X") + pdb_atom(" B2", "BEA", 5, "X"));
  EXPECT_EQ(prepare_balls(m).balls->size(), 2u);
  EXPECT_TRUE(is_noted(m, "kept as atoms of unknown element"));
}

std::string cif(const std::string& rows, const std::string& before = "") {
  return "data_T\n" + before +
         "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
         "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site."
         "label_seq_id\n"
         "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n"
         "_atom_site.B_iso_or_equiv\n" +
         rows;
}

TEST(StatedElements, ChargesAreNoPartOfThem) {
  const Molecule m = read_text("a.cif", cif("HETATM Zn2+ ZN . ZN A . 0 0 0 1 20\n"
                                            "ATOM O2- O . GLY B 1 5 0 0 1 20\n"
                                            "ATOM N1+ N . GLY B 1 9 0 0 1 20\n"
                                            "HETATM Cl- CL . CL C . 19 0 0 1 20\n"
                                            "ATOM C12 CA . GLY B 1 29 0 0 1 20\n"));
  const Element expected[] = {30, 8, 7, 17, 6};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(m.atoms[k].element, expected[k]) << k;
  EXPECT_EQ(prepare_balls(m).balls->radii[0], 740);
  EXPECT_TRUE(is_noted(m, "invalid element: 1"));
}

TEST(StatedElements, NamesFromTheFirstColumn) {
  // "F1" and "OAB" show that names of this residue all begin in column 13. Mercury's residue shows
  // nothing.
  const Molecule m = read_text(
      "a.pdb",
      pdb_atom("CAA", "LIG", 0, "", "HETATM") + pdb_atom("CA", "LIG", 4, "", "HETATM") +
          pdb_atom("PB", "LIG", 8, "", "HETATM") + pdb_atom("OAB", "LIG", 12, "", "HETATM") +
          pdb_atom("HG", "MMC", 16, "", "HETATM") + pdb_atom(" C1", "MMC", 20, "", "HETATM"));
  const Element expected[] = {6, 6, 15, 8, 80, 6};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(m.atoms[k].element, expected[k]) << k;
}

TEST(StatedElements, NumbersInXyzFiles) {
  const auto first = [](const std::string& text) {
    return read_text("a.xyz", text).atoms[0].element;
  };
  EXPECT_EQ(first("4\n\n1 0 0 0\n2 2 0 0\n3 4 0 0\n1 6 0 0\n"), kUnknownElement) << "types";
  EXPECT_EQ(first("2\nAtoms. Timestep: 0\n6 0 0 0\n8 2 0 0\n"), kUnknownElement) << "LAMMPS";
  EXPECT_EQ(first("3\n\n8 0 0 0\n1 1 0 0\n1 0 1 0\n"), 8);
  EXPECT_EQ(first("2\n\n1 0 0 0\n1 0.74 0 0\n"), 1);
  EXPECT_EQ(first("2\n\n13C 0 0 0\n2H 1 0 0\n"), 6);
  EXPECT_EQ(first("1\n\nT 0 0 0\n"), 1);
}

TEST(ReadPqr, ElementsBehindAndRadiiBefore) {
  const Molecule m =
      read_text("a.pqr",
                "ATOM      1  CL  UNL     1      -0.726  -0.382  -1.056 -0.15304956   1.750  Cl\n"
                "HETATM    2  C   UNL A   1       1.726  -0.382  -1.056  0.15304956   1.700  C\n");
  EXPECT_EQ(m.atoms[0].element, 17);
  EXPECT_FALSE(m.atoms[1].element_guessed);
  EXPECT_EQ(m.atoms[1].file_radius, 1700);
  const Molecule old =
      read_text("a.pqr",
                "REMARK  atom radii in columns 55-62\nREMARK  atom charges in columns 63-70\n"
                "ATOM      1  N   ALA     1       1.000   2.000   3.000  1.8240 -0.4157\n");
  EXPECT_EQ(old.atoms[0].file_radius, 1824);
}

TEST(ReadPqr, APdbFileIsNamed) {
  const ReadError error =
      refusal("a.pqr", "ATOM      1  N   THR A   1      17.047  14.099   3.625  1.00 13.79\n");
  EXPECT_NE(error.reason().find("PDB file"), std::string::npos) << error.reason();
  // Other programs also print two decimals.
  EXPECT_EQ(
      read_text("a.pqr", "ATOM      1  N   THR A   1      17.047  14.099   3.625  0.15  1.55\n")
          .atoms[0]
          .file_radius,
      1550);
}

TEST(ReadComponent, ItsCoordinatesAreRead) {
  const std::string head =
      "data_X\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_"
      "symbol\n"
      "_chem_comp_atom.model_Cartn_x\n_chem_comp_atom.model_Cartn_y\n_chem_comp_atom.model_Cartn_"
      "z\n"
      "_chem_comp_atom.pdbx_model_Cartn_x_ideal\n_chem_comp_atom.pdbx_model_Cartn_y_ideal\n"
      "_chem_comp_atom.pdbx_model_Cartn_z_ideal\n";
  const Molecule m = read_text("a.cif", head + "XYZ CL1 CL 1 2 3 4 5 6\nXYZ C2 C 1 2 4.5 4 5 7\n");
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.atoms[0].element, 17);
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{1000, 2000, 4500}));
  EXPECT_EQ(m.atoms[0].kind, ResidueKind::ligand);
  const Molecule ideal =
      read_text("a.cif", head + "XYZ CL1 CL ? ? ? 4 5 6\nXYZ C2 C 1 2 3 4 5 7\n");
  EXPECT_EQ(ideal.atoms[1].position, (LatticePoint{4000, 5000, 7000}));
}

TEST(Confidences, AreToldByWhatTheFileSays) {
  const std::string atoms = pdb_atom(" CA", "GLY", 0, "C");
  const std::string title = "TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR ALBUMIN (P02768)\n";
  EXPECT_TRUE(read_text("a.pdb", title + atoms).has_confidences);
  EXPECT_TRUE(
      read_text("a.pdb", "TITLE     ESMFOLD V1 PREDICTION FOR X\n" + atoms).has_confidences);
  EXPECT_FALSE(read_text("a.pdb", "EXPDTA    X-RAY DIFFRACTION\n" + title + atoms).has_confidences);
  EXPECT_FALSE(
      read_text("a.pdb", "REMARK   3 STARTING MODEL: ALPHAFOLD\n" + atoms).has_confidences);
  EXPECT_FALSE(read_text("a.pdb", atoms).has_confidences);
  const std::string row = "ATOM C CA . GLY A 1 0 0 0 1 90.1\n";
  const std::string metric = "loop_\n_ma_qa_metric.id\n_ma_qa_metric.name\n1 pLDDT\n";
  EXPECT_TRUE(read_text("a.cif", cif(row, metric)).has_confidences);
  EXPECT_TRUE(read_text("a.cif", cif(row, "_ma_qa_metric.name pLDDT\n")).has_confidences);
  EXPECT_FALSE(
      read_text("a.cif", cif(row, metric + "_exptl.method 'X-RAY DIFFRACTION'\n")).has_confidences);
}

TEST(Confidences, DoNotChooseLocations) {
  const std::string rows = "ATOM C CA A GLY A 1 0 0 0 0.5 90\nATOM C CA B GLY A 1 1 0 0 0.5 20\n";
  const auto minor = [](const Molecule& m) { return minor_altlocs(m, 0, m.atoms.size()); };
  EXPECT_EQ(minor(read_text("a.cif", cif(rows))), (std::vector{true, false})) << "lower B factor";
  EXPECT_EQ(minor(read_text("a.cif", cif(rows, "_ma_qa_metric.name pLDDT\n"))),
            (std::vector{false, true}))
      << "the first letter";
}

}  // namespace
}  // namespace alphascope
