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

}  // namespace
}  // namespace alphascope
