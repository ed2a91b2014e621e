// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the nucleotides that ladders are drawn through.
#include "core/secondary/nucleotides.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "core/read/read_molecule.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope {
namespace {

Molecule sample(const char* file) {
  return read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules" / file);
}

std::vector<Nucleotide> nucleotides_of(const Molecule& molecule) {
  return find_nucleotides(molecule, molecule.models.front());
}

std::string name(const Molecule& m, std::uint32_t atom) {
  return std::string(m.text(m.atoms[atom].name));
}

TEST(Nucleotides, DnaHasTwoStrandsOfTwelve) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule molecule = read_molecule(testing::test_data_folder() / "ladder/1bna.pdb");
  const auto list = nucleotides_of(molecule);
  ASSERT_EQ(list.size(), 24u);
  EXPECT_EQ(
      std::count_if(list.begin(), list.end(), [](const Nucleotide& n) { return n.bound_to_next; }),
      22);
  EXPECT_FALSE(list[11].bound_to_next);  // the end of the first strand
  for (const Nucleotide& n : list) {
    EXPECT_EQ(name(molecule, n.backbone), "C4'");
    EXPECT_EQ(name(molecule, n.sugar), "C1'");
    const std::string residue(molecule.text(molecule.atoms[n.base].residue_name));
    const bool purine = residue == "DA" || residue == "DG";
    EXPECT_EQ(name(molecule, n.base), purine ? "N1" : "N3") << residue;
    std::string outline;
    for (std::size_t k = 0; k < n.corners; ++k) outline += name(molecule, n.outline[k]) + " ";
    EXPECT_EQ(outline, purine ? "N1 C2 N3 C4 N9 C8 N7 C5 C6 " : "N1 C2 N3 C4 C5 C6 ") << residue;
  }
}

TEST(Nucleotides, ProteinsAndLigandsHaveNone) {
  EXPECT_TRUE(nucleotides_of(sample("4hhb.pdb.gz")).empty());
}

TEST(Nucleotides, PhosphorusAloneMakesATraceWithoutRungs) {
  const TemporaryFile file(
      "phosphorus.pdb",
      "ATOM      1  P     A A   1       0.000   0.000   0.000  1.00  0.00           P\n"
      "ATOM      2  P     G A   2       6.000   0.000   0.000  1.00  0.00           P\n"
      "ATOM      3  P     C A   3      20.000   0.000   0.000  1.00  0.00           P\n");
  const Molecule molecule = read_molecule(file.path());
  const auto list = nucleotides_of(molecule);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_TRUE(list[0].bound_to_next);
  EXPECT_FALSE(list[1].bound_to_next);  // 14 Å away
  EXPECT_EQ(list[0].base, kNoAtom);
}

TEST(Nucleotides, AnIncompleteBaseHasNoOutline) {
  const TemporaryFile file(
      "base.pdb",
      "ATOM      1  C1'  DC A   1       0.000   0.000   0.000  1.00  0.00           C\n"
      "ATOM      2  N1   DC A   1       1.500   0.000   0.000  1.00  0.00           N\n"
      "ATOM      3  C2   DC A   1       2.200   1.200   0.000  1.00  0.00           C\n"
      "ATOM      4  N3   DC A   1       3.600   1.200   0.000  1.00  0.00           N\n"
      "ATOM      5  C4   DC A   1       4.300   0.000   0.000  1.00  0.00           C\n"
      "ATOM      6  C5   DC A   1       3.600  -1.200   0.000  1.00  0.00           C\n");
  const Molecule molecule = read_molecule(file.path());
  const auto list = nucleotides_of(molecule);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].base, 3u);
  EXPECT_EQ(list[0].corners, 0u) << "C6 is missing";
}

}  // namespace
}  // namespace alphascope
