// SPDX-License-Identifier: GPL-3.0-or-later
// Tests bonds against files that state them, and against the chemistry of residues.
#include "core/bonds/bonds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/bonds/covalent_radii.hpp"
#include "core/bonds/residue_structures.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/atom_type.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text_files/text_file.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

Molecule sample(const char* file) {
  return read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules" / file);
}

BondList bonds_of(const Molecule& molecule) {
  return find_bonds(molecule, molecule.models.front());
}

std::string atom(int serial, const char* name, const char* residue, int number, double x, double y,
                 double z, const char* element, char altloc = ' ', bool hetero = false) {
  char line[100];
  std::snprintf(
      line, sizeof line, "%-6s%5d %-4s%c%3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n",
      hetero ? "HETATM" : "ATOM", serial, name, altloc, residue, number, x, y, z, element);
  return line;
}

using Pair = std::pair<std::string, std::string>;

std::string name_of(const Molecule& m, std::uint32_t i) {
  return std::string(m.text(m.atoms[i].name));
}

std::set<Pair> names(const Molecule& m, const std::vector<Bond>& bonds) {
  std::set<Pair> result;
  for (const Bond& bond : bonds) {
    result.insert(std::minmax(name_of(m, bond.a), name_of(m, bond.b)));
  }
  return result;
}

std::string pdb_text_without(const std::filesystem::path& path, const std::string& record,
                             const std::string& other = "CONECT") {
  std::istringstream text(std::string(load_text(path, std::uint64_t{1} << 30, {}).text));
  std::string kept;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with(record) && !line.starts_with(other)) kept += line + '\n';
  }
  return kept;
}

TEST(Bonds, CrambinHasThreeDisulphides) {
  const Molecule m = sample("1crn.pdb");
  const BondList list = bonds_of(m);
  // 327 atoms in one chain, with 6 rings of side chains (5 prolines, and tyrosine and phenylalanine
  // have one each) and 3 disulphides: 327 - 1 + 5 + 3 + 3 bonds.
  EXPECT_EQ(list.bonds.size(), 337u);
  EXPECT_EQ(list.guessed(), 0u);
  EXPECT_EQ(list.reasons[static_cast<std::size_t>(BondReason::chain_link)], 45u);
  std::set<std::pair<int, int>> disulphides;
  for (const Bond& bond : list.bonds) {
    if (name_of(m, bond.a) != "SG" || name_of(m, bond.b) != "SG") continue;
    EXPECT_EQ(bond.why, BondReason::file);
    EXPECT_EQ(bond.order, BondOrder::one);
    disulphides.emplace(m.atoms[bond.a].residue_number, m.atoms[bond.b].residue_number);
  }
  EXPECT_EQ(disulphides, (std::set<std::pair<int, int>>{{3, 40}, {4, 32}, {16, 26}}));
  EXPECT_NE(summary(list).find("337 bonds: 3 from the file"), std::string::npos) << summary(list);
}

TEST(Bonds, DisulphidesWithoutRecordsAreGuessedAndCounted) {
  const std::filesystem::path path =
      std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/1crn.pdb";
  const Molecule m = read_text("a.pdb", pdb_text_without(path, "SSBOND"));
  const BondList list = bonds_of(m);
  EXPECT_EQ(list.bonds.size(), 337u);
  EXPECT_EQ(list.guessed(), 3u);
}

TEST(Bonds, IronOfHaemIsCoordinated) {
  const Molecule m = sample("4hhb.pdb.gz");
  const BondList list = bonds_of(m);
  std::map<std::uint32_t, std::multiset<std::string>> ligands;
  for (const Bond& bond : list.bonds) {
    const bool a = name_of(m, bond.a) == "FE", b = name_of(m, bond.b) == "FE";
    EXPECT_EQ(bond.kind == BondKind::coordination, a || b);
    if (a || b) ligands[a ? bond.a : bond.b].insert(name_of(m, a ? bond.b : bond.a));
  }
  ASSERT_EQ(ligands.size(), 4u);
  for (const auto& [iron, atoms] : ligands) {
    EXPECT_EQ(atoms, (std::multiset<std::string>{"NA", "NB", "NC", "ND", "NE2"}));
  }
  EXPECT_EQ(list.coordinations, 20u);
}

// Bonds within each residue that has all its heavy atoms, without OXT.
TEST(Bonds, CompleteResiduesHaveTheirBonds) {
  const std::map<std::string, std::size_t> expected = {
      {"ALA", 4}, {"ARG", 10}, {"ASN", 7}, {"ASP", 7},  {"CYS", 5},  {"GLN", 8}, {"GLU", 8},
      {"GLY", 3}, {"HIS", 10}, {"ILE", 7}, {"LEU", 7},  {"LYS", 8},  {"MET", 7}, {"PHE", 11},
      {"PRO", 7}, {"SER", 5},  {"THR", 6}, {"TRP", 15}, {"TYR", 12}, {"VAL", 6}};
  const Molecule m = sample("4hhb.pdb.gz");
  using Residue = std::pair<NameId, int>;
  std::map<Residue, std::size_t> atoms, bonds;
  std::map<Residue, std::string> names;
  for (const Atom& a : m.atoms) {
    if (a.kind != ResidueKind::polymer || m.text(a.name) == "OXT") continue;
    ++atoms[{a.chain, a.residue_number}];
    names[{a.chain, a.residue_number}] = m.text(a.residue_name);
  }
  const BondList list = bonds_of(m);
  for (const Bond& bond : list.bonds) {
    const Atom &a = m.atoms[bond.a], &b = m.atoms[bond.b];
    if (!same_residue_number(a, b) || m.text(a.name) == "OXT" || m.text(b.name) == "OXT") continue;
    ++bonds[{a.chain, a.residue_number}];
  }
  std::set<std::string> seen;
  std::size_t missing = 0;
  for (const auto& [residue, name] : names) {
    const ResidueStructure* structure = residue_structure(name);
    ASSERT_NE(structure, nullptr) << name;
    if (atoms[residue] + 1 != structure->atoms.size()) continue;
    EXPECT_LE(bonds[residue], expected.at(name)) << name << ' ' << residue.second;
    missing += expected.at(name) - bonds[residue];
    seen.insert(name);
  }
  // In this entry CZ of arginine 92 in chain C is 2.97 Å from NE.
  EXPECT_EQ(missing, 1u);
  EXPECT_EQ(list.too_long, 1u);
  EXPECT_GE(seen.size(), 19u);  // haemoglobin has no isoleucine
  // The number of bonds of a connected structure is one less than that of atoms, and one more for
  // each ring.
  for (const auto& [name, count] : expected) {
    EXPECT_EQ(residue_structure(name)->bonds.size(), count + 1) << name << " with OXT";
  }
  const std::map<std::string, std::size_t> nucleotides = {{"A", 25}, {"C", 22}, {"G", 26},
                                                          {"I", 25}, {"T", 23}, {"U", 22}};
  for (const auto& [name, count] : nucleotides) {
    EXPECT_EQ(residue_structure(name)->bonds.size(), count) << name << " with OP3 and O2'";
  }
}

// In sixths of a bond. An aromatic bond counts 4/3, so that an atom of two rings has four bonds.
int sixths(BondOrder order) {
  switch (order) {
    case BondOrder::two:
      return 12;
    case BondOrder::three:
      return 18;
    case BondOrder::aromatic:
      return 8;
    default:
      return 6;
  }
}

TEST(Bonds, ValencesOfResidueStructures) {
  const std::map<char, int> most = {{'C', 4}, {'N', 4}, {'O', 2}, {'S', 2}, {'P', 5}};
  for (const char* name : {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE",
                           "LEU", "LYS", "MET", "MSE", "PHE", "PRO", "SEC", "SER", "THR", "TRP",
                           "TYR", "VAL", "A",   "C",   "G",   "I",   "T",   "U"}) {
    const ResidueStructure* structure = residue_structure(name);
    ASSERT_NE(structure, nullptr) << name;
    std::vector<int> sums(structure->atoms.size(), 0);
    for (const StructureBond& bond : structure->bonds) {
      sums[bond.a] += sixths(bond.order);
      sums[bond.b] += sixths(bond.order);
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      // C and N have one bond to a neighbour. OXT takes the place of C's.
      const std::string_view atom = structure->atoms[k];
      const int links = atom == "N" || atom == "O3'" ? 1 : 0;
      EXPECT_LE(sums[k] + 6 * links, 6 * most.at(atom[0])) << name << ' ' << atom;
    }
  }
}

TEST(Bonds, HydrogensHaveOneBondAndNoElementTooMany) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule m = read_molecule(test_data("ladder/adk_open.pdb.gz"));
  const BondList list = bonds_of(m);
  std::vector<int> counts(m.atoms.size(), 0);
  for (const Bond& bond : list.bonds) {
    ++counts[bond.a];
    ++counts[bond.b];
  }
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
    if (m.atoms[i].element == kHydrogen) {
      EXPECT_EQ(counts[i], 1) << atom_label(m, i);
    } else {
      EXPECT_LE(counts[i], most_bonds(m.atoms[i].element)) << atom_label(m, i);
      EXPECT_GE(counts[i], 1) << atom_label(m, i);
    }
  }
  EXPECT_EQ(list.guessed(), 0u);
}

// The same bonds follow from distances where the file does not state them.
TEST(Bonds, LigandsHaveTheBondsOfConect) {
  ALPHASCOPE_NEED_TEST_DATA();
  std::size_t stated = 0, both = 0, extra = 0;
  for (const char* file :
       {"cavities/fpocket/1atp.pdb.gz", "cavities/fpocket/1uyd.pdb.gz",
        "cavities/sbl_vorlume/2w83.pdb.gz", "cavities/p2rank/1fbl.pdb.gz", "thesis/1aon.pdb.gz"}) {
    const Molecule with = read_molecule(test_data(file));
    const Molecule without = read_text("a.pdb", pdb_text_without(test_data(file), "CONECT"));
    ASSERT_EQ(with.atoms.size(), without.atoms.size());
    const auto of_ligands = [](const Molecule& m) {
      std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
      for (const Bond& bond : bonds_of(m).bonds) {
        const bool ligand = m.atoms[bond.a].kind == ResidueKind::ligand &&
                            m.atoms[bond.b].kind == ResidueKind::ligand;
        if (ligand && bond.kind == BondKind::covalent) pairs.emplace(bond.a, bond.b);
      }
      return pairs;
    };
    const auto a = of_ligands(with), b = of_ligands(without);
    stated += a.size();
    for (const auto& pair : b) (a.contains(pair) ? both : extra) += 1;
  }
  EXPECT_GT(stated, 400u);
  EXPECT_EQ(both, stated);
  EXPECT_EQ(extra, 0u);
}

TEST(Bonds, NucleotidesAreLinked) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule m = read_molecule(test_data("ladder/1bna.pdb"));
  const BondList list = bonds_of(m);
  // Two strands of twelve nucleotides.
  EXPECT_EQ(list.reasons[static_cast<std::size_t>(BondReason::chain_link)], 22u);
  EXPECT_EQ(list.guessed(), 0u);
  // 486 atoms of two connected strands. Each A and G has three rings with its sugar, C and T two.
  EXPECT_EQ(list.bonds.size(), 486u - 2 + 12 * 3 + 12 * 2);
}

TEST(Bonds, AlternativeLocationsAreNotBonded) {
  std::string text;
  text += atom(1, " N", "SER", 1, 0, 0, 0, "N") + atom(2, " CA", "SER", 1, 1.46, 0, 0, "C");
  text += atom(3, " C", "SER", 1, 2.0, 1.4, 0, "C") + atom(4, " O", "SER", 1, 1.2, 2.3, 0, "O");
  text += atom(5, " CB", "SER", 1, 2.0, -0.8, 1.2, "C", 'A') +
          atom(6, " CB", "SER", 1, 2.0, -0.7, 1.3, "C", 'B');
  text += atom(7, " OG", "SER", 1, 3.4, -0.8, 1.2, "O", 'A') +
          atom(8, " OG", "SER", 1, 1.5, -2.0, 1.3, "O", 'B');
  // A ligand with two locations, for bonds by distance.
  text += atom(9, " C1", "LIG", 2, 20, 0, 0, "C", ' ', true) +
          atom(10, " O1", "LIG", 2, 21.4, 0, 0, "O", 'A', true) +
          atom(11, " O2", "LIG", 2, 21.0, 1.0, 0, "O", 'B', true);
  const Molecule m = read_text("a.pdb", text);
  const BondList list = bonds_of(m);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Bond& bond : list.bonds) {
    EXPECT_TRUE(may_meet(m.atoms[bond.a], m.atoms[bond.b]));
    pairs.emplace(bond.a, bond.b);
  }
  EXPECT_EQ(pairs, (std::set<std::pair<std::uint32_t, std::uint32_t>>{
                       {0, 1}, {1, 2}, {2, 3}, {1, 4}, {1, 5}, {4, 6}, {5, 7}, {8, 9}, {8, 10}}));
  EXPECT_EQ(list.guessed(), 2u);
}

TEST(Bonds, LocationsOfAFileAreNotBonded) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule m = read_molecule(test_data("archive/1ejg.pdb.gz"));
  std::size_t with_letters = 0;
  for (const Bond& bond : bonds_of(m).bonds) {
    ASSERT_TRUE(may_meet(m.atoms[bond.a], m.atoms[bond.b]));
    with_letters += m.atoms[bond.a].altloc == 'B' && m.atoms[bond.b].altloc == 'B';
  }
  EXPECT_GT(with_letters, 20u);
}

TEST(Bonds, WaterMetalsAndIons) {
  std::string text;
  text += atom(1, " O", "HOH", 1, 0, 0, 0, "O", ' ', true) +
          atom(2, " H1", "HOH", 1, 0.96, 0, 0, "H", ' ', true) +
          atom(3, " H2", "HOH", 1, -0.24, 0.93, 0, "H", ' ', true);
  text += atom(4, "MG", " MG", 2, 0, 0, 2.1, "MG", ' ', true);
  // A second water at 1.5 Å has no bond to the first; neither has chloride.
  text += atom(5, " O", "HOH", 3, 0, -1.4, 0, "O", ' ', true);
  text += atom(6, "CL", " CL", 4, 1.4, -1.4, 0, "CL", ' ', true);
  // Sodium at the place of a bond to carbon has none.
  text += atom(7, " C1", "LIG", 5, 30, 0, 0, "C", ' ', true) +
          atom(8, "NA", " NA", 6, 32.0, 0, 0, "NA", ' ', true);
  const Molecule m = read_text("a.pdb", text);
  const BondList list = bonds_of(m);
  ASSERT_EQ(list.bonds.size(), 3u) << summary(list);
  EXPECT_EQ(names(m, list.bonds), (std::set<Pair>{{"H1", "O"}, {"H2", "O"}, {"MG", "O"}}));
  EXPECT_EQ(list.coordinations, 1u);
}

TEST(Bonds, NearestPartnersCountWhereAtomsCrowd) {
  // Carbon with six neighbours in bonding distance keeps the four nearest.
  std::string text = atom(1, " C1", "LIG", 1, 0, 0, 0, "C", ' ', true);
  const double places[6][3] = {{1.4, 0, 0},   {-1.42, 0, 0}, {0, 1.44, 0},
                               {0, -1.46, 0}, {0, 0, 1.58},  {0, 0, -1.59}};
  for (int k = 0; k < 6; ++k) {
    const std::string name = " F" + std::to_string(k + 1);
    text += atom(2 + k, name.c_str(), "LIG", 1, places[k][0], places[k][1], places[k][2], "F", ' ',
                 true);
  }
  const Molecule m = read_text("a.pdb", text);
  EXPECT_EQ(names(m, bonds_of(m).bonds),
            (std::set<Pair>{{"C1", "F1"}, {"C1", "F2"}, {"C1", "F3"}, {"C1", "F4"}}));
}

TEST(Bonds, TooLongOnesAreLeftOutAndCounted) {
  const Molecule m =
      read_text("a.pdb", atom(1, " C1", "LIG", 1, 0, 0, 0, "C", ' ', true) +
                             atom(2, " C2", "LIG", 1, 3.1, 0, 0, "C", ' ', true) +
                             atom(3, " C3", "LIG", 1, 0, 3.0, 0, "C", ' ', true) +
                             "CONECT    1    2\nCONECT    1    3\nCONECT    1   99\n");
  const BondList list = bonds_of(m);
  EXPECT_EQ(list.bonds.size(), 1u);
  EXPECT_EQ(list.too_long, 1u);
  EXPECT_EQ(list.unresolved, 1u);
  EXPECT_NE(summary(list).find("1 left out because the atoms are too far apart"),
            std::string::npos);
}

TEST(Bonds, ResiduesBeyondAGapAreNotLinked) {
  const auto residue = [](int number, double x) {
    return atom(1, " N", "GLY", number, x, 0, 0, "N") +
           atom(2, " CA", "GLY", number, x + 1.2, 0.8, 0, "C") +
           atom(3, " C", "GLY", number, x + 2.47, 0, 0, "C") +
           atom(4, " O", "GLY", number, x + 2.47, -1.2, 0, "O");
  };
  const Molecule m = read_text("a.pdb", residue(1, 0) + residue(2, 3.8) + residue(7, 9.0));
  const BondList list = bonds_of(m);
  EXPECT_EQ(list.reasons[static_cast<std::size_t>(BondReason::chain_link)], 1u);
  EXPECT_EQ(list.bonds.size(), 10u);
}

TEST(Bonds, CopiesHaveTheBondsOfTheFirst) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule deposited = read_molecule(test_data("ladder/1m4x.cif.gz"));
  const Molecule m = expand_assembly(deposited, "5");  // 30 copies
  const BondList one = bonds_of(deposited), all = bonds_of(m);
  ASSERT_EQ(all.bonds.size(), 30 * one.bonds.size());
  EXPECT_EQ(all.reasons[1], 30 * one.reasons[1]);
  for (std::size_t k = 0; k < all.bonds.size(); ++k) {
    const AtomSource a = atom_source(m, all.bonds[k].a), b = atom_source(m, all.bonds[k].b);
    ASSERT_EQ(a.copy, b.copy);
    ASSERT_EQ(a.deposited, one.bonds[k % one.bonds.size()].a);
    ASSERT_EQ(b.deposited, one.bonds[k % one.bonds.size()].b);
  }
}

TEST(Bonds, BetweenBalls) {
  const Molecule m = sample("1crn.pdb");
  const BondList list = bonds_of(m);
  BallOptions options;
  options.selection = "name CA or name C";
  const PreparedBalls prepared = prepare_balls(m, options);
  const std::vector<Bond> bonds = bonds_of_balls(list.bonds, prepared.atom_of_ball);
  EXPECT_EQ(bonds.size(), 46u);
  for (const Bond& bond : bonds) {
    EXPECT_EQ(name_of(m, prepared.atom_of_ball[bond.a]), "CA");
    EXPECT_EQ(name_of(m, prepared.atom_of_ball[bond.b]), "C");
  }
  EXPECT_TRUE(bonds_of_balls(list.bonds, {}).empty());
}

TEST(Bonds, FilesWithoutResiduesHaveBondsByDistance) {
  const Molecule m = read_text("ethene.xyz",
                               "6\nethene\nC 0 0 0.66\nC 0 0 -0.66\nH 0 0.92 1.23\n"
                               "H 0 -0.92 1.23\nH 0 0.92 -1.23\nH 0 -0.92 -1.23\n");
  const BondList list = bonds_of(m);
  EXPECT_EQ(list.bonds.size(), 5u);
  EXPECT_EQ(list.guessed(), 5u);
}

TEST(Bonds, ManyAtomsAtOnePlaceTakeLinearTime) {
  std::string text = "40000\nx\n";
  for (int k = 0; k < 40000; ++k) {
    text += "C " + std::to_string(k % 100 * 0.01) + ' ' + std::to_string(k / 100 % 100 * 0.01) +
            ' ' + std::to_string(k / 10000 * 0.01) + '\n';
  }
  const BondList crowded = bonds_of(read_text("a.xyz", text));
  EXPECT_EQ(crowded.bonds.size(), 0u);
  EXPECT_EQ(crowded.crowded, 40000u);
  EXPECT_NE(summary(crowded).find("too many atoms are at one place"), std::string::npos);
  // Coincident atoms have no bond between them.
  const BondList coincident = bonds_of(read_text("a.xyz", "3\nx\nC 0 0 0\nC 0 0 0\nO 1.2 0 0\n"));
  EXPECT_EQ(coincident.bonds.size(), 2u);
}

TEST(Bonds, Cancels) {
  const Molecule m = sample("4hhb.pdb.gz");
  const RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(find_bonds(m, m.models.front(), context), Cancelled);
}

TEST(Bonds, RadiiAreThoseOfCordero) {
  EXPECT_EQ(covalent_radius_angstrom(1), 0.31);
  EXPECT_EQ(covalent_radius_angstrom(6), 0.76);
  EXPECT_EQ(covalent_radius_angstrom(26), 1.32);
  EXPECT_EQ(covalent_radius_angstrom(53), 1.39);
  EXPECT_EQ(covalent_radius_angstrom(80), 1.32);
  EXPECT_EQ(covalent_radius_angstrom(87), 2.60);
  EXPECT_EQ(covalent_radius_angstrom(96), 1.69);
  EXPECT_EQ(covalent_radius_angstrom(97), 0);
  EXPECT_EQ(covalent_radius_angstrom(kUnknownElement), 0);
}

}  // namespace
}  // namespace alphascope
