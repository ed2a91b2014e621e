// SPDX-License-Identifier: GPL-3.0-or-later
// Tests PDB files as programs write them. They have frames without MODEL, lines that are nearly
// records, chains of two letters and repeated residue numbers. PDBQT is tested as well.
#include <string>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// An ATOM record with everything in its columns. residue: columns 18-27, such as "GLY A   1 ".
std::string atom(int serial, const std::string& name, const std::string& residue, int x,
                 const std::string& behind = "  1.00 20.00          ",
                 const std::string& record = "ATOM  ") {
  char line[128];
  std::snprintf(line, sizeof line, "%-6s%5d %-4s %-10s   %8.3f%8.3f%8.3f%s\n", record.c_str(),
                serial, name.c_str(), residue.c_str(), double(x), 0.0, 0.0, behind.c_str());
  return line;
}

std::string frame(int first_serial, const std::string& chain) {
  return atom(first_serial, " N", "GLY " + chain + "   1 ", first_serial) +
         atom(first_serial + 1, " CA", "GLY " + chain + "   1 ", first_serial + 1);
}

std::string all_notes(const Molecule& m) {
  std::string text;
  for (const std::string& note : m.notes) text += note + "\n";
  return text;
}

bool is_noted(const Molecule& m, const std::string& words) {
  return all_notes(m).find(words) != std::string::npos;
}

TEST(PdbFrames, TheSameAtomsBehindEndAreModels) {
  const Molecule m = read_text(
      "a.pdb", frame(1, "A") + "END\n" + frame(1, "A") + "END\n" + frame(1, "A") + "END\n");
  ASSERT_EQ(m.models.size(), 3u);
  EXPECT_EQ(m.models[2].begin, 4u);
  EXPECT_EQ(m.models[2].number, 3);
  EXPECT_TRUE(is_noted(m, "read as 3 models")) << all_notes(m);
  // The last frame may have been cut off.
  EXPECT_EQ(
      read_text("a.pdb", frame(1, "A") + "END\n" + atom(1, " N", "GLY A   1 ", 5)).models.size(),
      2u);
}

TEST(PdbFrames, BehindTerTheSerialNumbersBeginAnewToo) {
  const std::string two_chains = frame(1, "A") + "TER\n" + frame(4, "B") + "TER\n";
  EXPECT_EQ(read_text("a.pdb", two_chains + two_chains).models.size(), 2u);
  EXPECT_EQ(read_text("a.pdb", frame(1, "A") + "TER\n" + frame(4, "A") + "END\n").models.size(), 1u)
      << "a second copy of the chain";
}

TEST(PdbFrames, OtherAtomsBehindEndAreOfTheSameModel) {
  EXPECT_EQ(read_text("a.pdb", frame(1, "A") + "END\n" + frame(1, "B") + "END\n").models.size(),
            1u);
  EXPECT_EQ(
      read_text("a.pdb", frame(1, "A") + "END\n" + frame(1, "A") + frame(3, "B")).models.size(),
      1u);
  EXPECT_EQ(read_text("a.pdb", "MODEL        1\n" + frame(1, "A") + "END\n" + frame(1, "A"))
                .models.size(),
            1u);
}

TEST(PdbLines, NearlyRecordsAreReadAndSaid) {
  std::string lower = atom(2, " CA", "GLY A   1 ", 2), word = atom(3, " C", "GLY A   1 ", 3),
              het = atom(4, " O", "GLY A   1 ", 4, "  1.00 20.00", "HETATM"),
              seven = atom(5, " CB", "ALA A   2 ", 5);
  lower.replace(0, 4, "atom");
  word.replace(0, 6, "ATOMS ");
  het.replace(0, 7, "HETATOM");
  seven.replace(4, 7, "1000000");
  const Molecule m = read_text("a.pdb", " " + atom(1, " N", "GLY A   1 ", 1) + lower + word + het +
                                            seven + "#" + atom(6, " CG", "ALA A   2 ", 6) +
                                            "REMARK " + atom(7, " CG", "ALA A   2 ", 7));
  ASSERT_EQ(m.atoms.size(), 5u);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(m.atoms[std::size_t(k)].position.x, 1000 * (k + 1)) << k;
  EXPECT_TRUE(m.atoms[3].hetero);
  EXPECT_EQ(m.atoms[4].serial, 1000000);
  EXPECT_TRUE(is_noted(m, "4 (lines 1, 2, 3, 4)")) << all_notes(m);
  EXPECT_TRUE(is_noted(m, "not read: 2 (lines 6, 7)")) << all_notes(m);
}

TEST(PdbLines, RemarksAboutAtomsAreNoAtoms) {
  const Molecule m = read_text("a.pdb",
                               "REMARK 500 ATOM   N   GLY A   1  IS FAR FROM ITS PLACE\n"
                               "REMARK   3   ATOMS WITH B OF 1.000\n" +
                                   frame(1, "A"));
  EXPECT_EQ(m.atoms.size(), 2u);
  EXPECT_TRUE(m.notes.empty() || !is_noted(m, "look like atoms"));
}

TEST(PdbLines, LinesMayEndWithLfCr) {
  const Molecule m = read_text(
      "a.pdb", atom(1, " N", "GLY A   1 ", 1) + "\r" + atom(2, " CA", "GLY A   1 ", 2) + "\r");
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.atoms[1].position.x, 2000);
}

TEST(PdbLines, AtomsWithoutAPlaceAreLeftOut) {
  const std::string unknown =
      "ATOM      2  CA  GLY A   1    9999.0009999.0009999.000  1.00 20.00\n";
  const Molecule m = read_text("a.pdb", atom(1, " N", "GLY A   1 ", 1) + unknown);
  ASSERT_EQ(m.atoms.size(), 1u);
  EXPECT_TRUE(is_noted(m, "9999.000): 1 (line 2)")) << all_notes(m);
  EXPECT_EQ(read_text("a.pdb", "ATOM      1  CA  GLY A   1    9999.000   1.000   2.000\n")
                .atoms[0]
                .position.x,
            9999000);
}

TEST(PdbChains, OfTwoLettersAreToldByTheWholeFile) {
  const std::string chain = atom(1, " N", "ALAAA   1 ", 1);
  const Molecule m = read_text(
      "a.pdb", atom(2, " FE", "HEMAA   2 ", 9, "  1.00 20.00          FE", "HETATM") + chain +
                   atom(3, " C1", "LIGAB   2 ", 20, "  1.00 20.00           C", "HETATM"));
  EXPECT_EQ(m.text(m.atoms[0].residue_name), "HEM");
  EXPECT_EQ(m.text(m.atoms[0].chain), "AA");
  EXPECT_EQ(m.text(m.atoms[2].residue_name), "LIG");
  EXPECT_EQ(m.text(m.atoms[2].chain), "AB");
  // MODRES has such a chain in columns 16-17.
  const Molecule modified =
      read_text("a.pdb", "MODRES 1ABC XYZAA    2  SER\n" + chain +
                             atom(2, " N", "XYZAA   2 ", 5, "  1.00 20.00           N", "HETATM"));
  EXPECT_EQ(modified.atoms[1].kind, ResidueKind::polymer);
}

TEST(PdbChains, NamesOfFourLettersStayNames) {
  const Molecule m =
      read_text("a.pdb", atom(1, " OH2", "TIP3W   1 ", 1) + atom(2, " CA", "ASPPA   2 ", 9) +
                             atom(3, " FE", "HEMAA   3 ", 20));
  EXPECT_EQ(m.text(m.atoms[0].residue_name), "TIP3");
  EXPECT_EQ(m.text(m.atoms[0].chain), "W");
  EXPECT_EQ(m.atoms[0].kind, ResidueKind::water);
  EXPECT_EQ(m.text(m.atoms[1].residue_name), "ASPP");
  EXPECT_EQ(m.text(m.atoms[2].residue_name), "HEMA");
}

TEST(PdbNumbers, ResiduesWithoutNumbersAreToldApart) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    text += atom(4 * k + 1, " N", "GLY A**** ", 10 * k) +
            atom(4 * k + 2, " CA", "GLY A**** ", 10 * k + 1) +
            atom(4 * k + 3, " C", "GLY A**** ", 10 * k + 3);
  }
  const Molecule m = read_text("a.pdb", text);
  const std::vector<std::uint32_t> all{0, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(atom_groups(m, all, AtomGrouping::residue).first,
            (std::vector<std::uint32_t>{0, 3, 6}));
  EXPECT_TRUE(is_noted(m, "are not numbers")) << all_notes(m);
}

TEST(PdbNumbers, LigandsWhoseAtomsAreNamedAlikeStayWhole) {
  const Molecule m =
      read_text("a.pdb", atom(1, " C", "UNL     0 ", 0) + atom(2, " C", "UNL     0 ", 2) +
                             atom(3, " N", "UNL     0 ", 4) + atom(4, " C", "UNL     0 ", 6));
  EXPECT_EQ(atom_groups(m, std::vector<std::uint32_t>{0, 1, 2, 3}, AtomGrouping::residue).size(),
            1u);
}

TEST(PdbNumbers, HexadecimalAfter9999) {
  const Molecule m =
      read_text("a.pdb", atom(1, " CA", "GLY A2710 ", 0) + atom(2, " CA", "GLY A9999 ", 4) +
                             atom(3, " CA", "GLY A2710 ", 8) + atom(4, " CA", "GLY A271a ", 12) +
                             atom(5, " CA", "GLY B   3 ", 16));
  const std::int32_t expected[] = {2710, 9999, 10000, 10010, 3};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(m.atoms[k].residue_number, expected[k]) << k;
}

TEST(PdbNumbers, IonsOfOneNumberAreNoLocationsOfOneAnother) {
  const auto zinc = [](int serial, char letter, double occupancy, int x) {
    char line[96];
    std::snprintf(line, sizeof line,
                  "HETATM%5d ZN  %c ZN W   0    %8.3f   0.000   0.000%6.2f 20.00          ZN\n",
                  serial, letter, double(x), occupancy);
    return std::string(line);
  };
  const Molecule m =
      read_text("a.pdb", zinc(1, ' ', 1, 0) + zinc(2, ' ', 1, 5) + zinc(3, 'A', .6, 10) +
                             zinc(4, 'B', .4, 11) + zinc(5, 'A', .3, 20) + zinc(6, 'B', .7, 21) +
                             zinc(7, ' ', 1, 30));
  const PreparedBalls prepared = prepare_balls(m);
  EXPECT_EQ(prepared.atom_of_ball, (std::vector<std::uint32_t>{0, 1, 2, 5, 6}));
  EXPECT_EQ(atom_groups(m, prepared.atom_of_ball, AtomGrouping::residue).size(), 5u);
}

std::string typed(int serial, const std::string& name, int x, const std::string& type) {
  return atom(serial, name, "LIG A   1 ", x, "  1.00  0.00    +0.100 " + type, "HETATM");
}

TEST(ReadPdbqt, TypesAreElements) {
  const std::pair<const char*, int> types[] = {
      {"A", 6},   {"C", 6},   {"NA", 7},  {"OA", 8},  {"SA", 16}, {"HD", 1},  {"Cl", 17},
      {"Br", 35}, {"F", 9},   {"Fe", 26}, {"Zn", 30}, {"Na", 11}, {"Hg", 80}, {"CG0", 6},
      {"I", 53},  {"MG", 12}, {"P", 15},  {"N", 7},   {"HS", 1},  {"Si", 14}};
  std::string text = "ROOT\n";
  int serial = 0;
  for (const auto& [type, element] : types) {
    ++serial;
    text += typed(serial, "X", serial, type);
  }
  text += typed(21, "G", 21, "G0") + "ENDROOT\nBRANCH   1   7\nENDBRANCH   1   7\nTORSDOF 1\n";
  const Molecule m = read_text("a.pdbqt", text);
  EXPECT_EQ(m.format, "PDBQT");
  ASSERT_EQ(m.atoms.size(), std::size(types) + 1);
  for (std::size_t k = 0; k < std::size(types); ++k) {
    EXPECT_EQ(m.atoms[k].element, types[k].second) << types[k].first;
    EXPECT_FALSE(m.atoms[k].element_guessed);
  }
  EXPECT_EQ(m.atoms.back().kind, ResidueKind::dummy) << "the glue of an opened ring";
  EXPECT_FALSE(m.atoms[0].has_b_factor) << "a pose has energies there";
}

TEST(ReadPdbqt, IsToldByItsContent) {
  const std::string receptor = typed(1, " C1", 0, "A ") + typed(2, "CL2", 4, "Cl");
  EXPECT_EQ(read_text("receptor.pdb", receptor).format, "PDBQT");
  const std::string remark = "REMARK  Name = a.xyz\n";
  EXPECT_EQ(read_text("ligand", remark + "ROOT\n" + receptor).format, "PDBQT");
  EXPECT_EQ(read_text("a.pdbqt", frame(1, "A")).format, "PDB") << "only the name says so";
  const std::string segment = atom(1, " CA", "GLY A   1 ", 0, "  1.00 20.00      SEG1 C");
  EXPECT_EQ(read_text("a.pdb", segment).format, "PDB");
}

TEST(ReadPdbqt, PosesAreModels) {
  const std::string pose = "REMARK VINA RESULT:    -7.1      0.000      0.000\nROOT\n" +
                           typed(1, " C1", 0, "A ") + "ENDROOT\nTORSDOF 0\nENDMDL\n";
  const Molecule m = read_text("out.pdbqt", "MODEL 1\n" + pose + "MODEL 2\n" + pose);
  EXPECT_EQ(m.models.size(), 2u);
  EXPECT_EQ(m.atoms.size(), 2u);
}

TEST(PdbAssemblies, AllChainsAndSeveralNumbers) {
  const std::string rows =
      "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";
  const Molecule m = read_text("a.pdb",
                               "REMARK 350 BIOMOLECULE: 1, 2\n"
                               "REMARK 350 APPLY THE FOLLOWING TO CHAINS: ALL\n" +
                                   rows + frame(1, "A") + frame(3, "B"));
  ASSERT_EQ(m.assemblies.list.size(), 2u);
  for (const Assembly& assembly : m.assemblies.list) {
    ASSERT_EQ(assembly.generators.size(), 1u) << assembly.id;
    EXPECT_EQ(assembly.generators[0].chains, (std::vector<std::string>{"A", "B"}));
  }
  EXPECT_EQ(m.assemblies.list[1].id, "2");
}

}  // namespace
}  // namespace alphascope
