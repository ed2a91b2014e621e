// SPDX-License-Identifier: GPL-3.0-or-later
// Compares secondary structure from hydrogen bonds with Debian's package dssp (mkdssp 4), residue
// by residue.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/read/read_molecule.hpp"
#include "core/run/child_program.hpp"
#include "core/secondary/secondary.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// Helices of all kinds, strands, barrels, DNA, an amyloid peptide, NMR, a cyclic peptide,
// alternative locations, virus proteins and cryo-EM.
constexpr const char* kFiles[] = {"ladder/1crn.cif",
                                  "ladder/1ubq.pdb",
                                  "ladder/1aki.pdb",
                                  "ladder/5i55.cif",
                                  "ladder/2buk.pdb",
                                  "ladder/1f2n.pdb.gz",
                                  "ladder/3sn6.cif.gz",
                                  "thesis/1u71.pdb",
                                  "thesis/4hhb.pdb.gz",
                                  "thesis/1k4c.pdb.gz",
                                  "thesis/2bg9.cif.gz",
                                  "cavities/fpocket/1atp.pdb.gz",
                                  "cavities/alphamol/1tim.pdb.gz",
                                  "cavities/p2rank/1fbl.pdb.gz",
                                  "cavities/fpocket/3lkf.pdb.gz",
                                  "cavities/fpocket/7taa.pdb.gz",
                                  "cavities/sbl_vorlume/1d66.pdb",
                                  "ensembles/1d3z.cif.gz",
                                  "archive/1sfi.cif.gz",
                                  "archive/2igd.cif.gz",
                                  "archive/1k6p.cif.gz"};

// Letters by chain and residue number with insertion code.
using Letters = std::map<std::pair<std::string, std::string>, char>;

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

// The lines behind the heading of a file of DSSP. Columns count from 0 here.
Letters letters_of_mkdssp(const std::filesystem::path& path) {
  std::ifstream file(path);
  Letters letters;
  bool begun = false;
  for (std::string line; std::getline(file, line);) {
    if (begun && line.size() > 16 && line[13] != '!') {
      letters[{without_blanks(line.substr(11, 1)), without_blanks(line.substr(5, 6))}] = line[16];
    }
    begun = begun || line.starts_with("  #  RESIDUE");
  }
  return letters;
}

Letters our_letters(const Molecule& molecule) {
  const SecondaryModel secondary =
      find_secondary(molecule, molecule.models.front(), SecondaryChoice::hydrogen_bonds);
  Letters letters;
  for (std::size_t k = 0; k < secondary.residues.size(); ++k) {
    if (!secondary.residues[k].complete()) continue;  // mkdssp does not list these
    const Atom& atom = molecule.atoms[secondary.residues[k].ca];
    const std::string number = std::to_string(atom.residue_number) + atom.insertion_code;
    letters[{std::string(molecule.text(atom.chain)), without_blanks(number)}] =
        secondary_code(secondary.kinds[k]);
  }
  return letters;
}

// Three kinds: helix, strand or bridge, other.
char of_three(char letter) {
  if (std::string("HGI").find(letter) != std::string::npos) return 'H';
  return letter == 'E' || letter == 'B' ? 'E' : ' ';
}
// Without polyproline, as before version 4.
char of_seven(char letter) {
  return letter == 'P' ? ' ' : letter;
}

struct Agreement {
  std::size_t residues = 0, eight = 0, seven = 0, three = 0;
  std::ostringstream differences;

  void add(const std::string& file, const Letters& ours, const Letters& theirs) {
    Letters all = ours;
    all.insert(theirs.begin(), theirs.end());
    for (const auto& [residue, ignored] : all) {
      const auto a = ours.find(residue), b = theirs.find(residue);
      ++residues;
      const bool both = a != ours.end() && b != theirs.end();
      eight += both && a->second == b->second;
      seven += both && of_seven(a->second) == of_seven(b->second);
      three += both && of_three(a->second) == of_three(b->second);
      if (both && a->second == b->second) continue;
      differences << file << ' ' << residue.first << ' ' << residue.second << ": '"
                  << (a == ours.end() ? '?' : a->second) << "', mkdssp '"
                  << (b == theirs.end() ? '?' : b->second) << "'\n";
    }
  }
};

TEST(DsspAgreement, ResiduesOfTwentyFiles) {
  ALPHASCOPE_NEED_TEST_DATA();
  const auto mkdssp = find_program("mkdssp");
  if (!mkdssp) {
    if (testing::test_data_is_required()) GTEST_FAIL() << "install the package dssp";
    GTEST_SKIP() << "install the package dssp to compare with it";
  }
  Agreement sum;
  for (const char* name : kFiles) {
    const TemporaryFile result("result.dssp", "");
    const std::string command = "'" + mkdssp->string() + "' --output-format dssp '" +
                                test_data(name).string() + "' '" + result.path().string() +
                                "' > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;  // NOLINT(cert-env33-c): a fixed command
    const Letters theirs = letters_of_mkdssp(result.path());
    ASSERT_GT(theirs.size(), 20u) << name;
    sum.add(name, our_letters(read_molecule(test_data(name))), theirs);
  }
  const auto share = [&](std::size_t equal) {
    return static_cast<double>(equal) / static_cast<double>(sum.residues);
  };
  RecordProperty("residues", static_cast<int>(sum.residues));
  RecordProperty("equal_of_eight", static_cast<int>(sum.eight));
  EXPECT_GT(sum.residues, 8000u);
  // Only 1K6P differs, in the four residues 49 to 52 of its chain B: they have two locations with
  // the same occupancy, and the program and DSSP do not choose the same one.
  EXPECT_GE(share(sum.eight), 0.999) << sum.differences.str();
  EXPECT_GE(share(sum.seven), 0.999) << sum.differences.str();
  EXPECT_GE(share(sum.three), 0.999) << sum.differences.str();
}

}  // namespace
}  // namespace alphascope
