// SPDX-License-Identifier: GPL-3.0-or-later
// Tests recorded bonds (LINK, CONECT, struct_conn) as evidence of what residues are.
#include <string>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/residue_reason.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/core/read/residue_dialects.hpp"

namespace alphascope {
namespace {

using Why = ResidueReason;

// GLY 1 and ALA 3 of a chain, and between them, 50 Å away, a residue of unknown name. No distance
// shows that it belongs there. Atoms are 1 to 4, 5 to 8, and 9 to 11.
std::vector<SampleAtom> torn_chain(const char* unknown = "Q7M") {
  std::vector<SampleAtom> sample;
  add_amino_acid(sample, "GLY", 'A', 1, 0, 0);
  add_amino_acid(sample, "ALA", 'A', 3, 7.6, 0);
  for (const auto& [name, element, x] :
       {std::tuple("N9", "N", 50.0), std::tuple("C7", "C", 51.5), std::tuple("ZN9", "ZN", 54.0)}) {
    sample.push_back({name, element, unknown, 'A', 302, x, 0, 0, true, ResidueKind::ligand, "3"});
  }
  return sample;
}

struct Bond {
  int from, to;  // serial numbers in the sample
};

std::string link(const std::vector<SampleAtom>& sample, const Bond& bond,
                 const char* symmetry = "1555") {
  const auto side = [&](int serial) {
    const SampleAtom& a = sample[static_cast<std::size_t>(serial - 1)];
    return text_of(" %-3s %3s %c%4d ", a.name, a.residue, a.chain, a.number);
  };
  std::string line = "LINK        " + side(bond.from);
  line.resize(42, ' ');
  line += side(bond.to);
  line.resize(59, ' ');
  return line + "  1555 " + text_of("%6s", symmetry) + "  1.33\n";
}

std::string struct_conn(const std::vector<SampleAtom>& sample, const std::vector<Bond>& bonds,
                        const char* type, const char* symmetry = "1_555") {
  std::string text = "loop_\n_struct_conn.id\n_struct_conn.conn_type_id\n";
  for (const char* partner : {"ptnr1", "ptnr2"}) {
    for (const char* column : {"auth_asym_id", "auth_seq_id", "label_atom_id", "symmetry"}) {
      text += std::string("_struct_conn.") + partner + "_" + column + "\n";
    }
  }
  for (const Bond& bond : bonds) {
    text += std::string("b ") + type;
    for (const int serial : {bond.from, bond.to}) {
      const SampleAtom& a = sample[static_cast<std::size_t>(serial - 1)];
      text += text_of(" %c %d %s %s", a.chain, a.number, a.name,
                      serial == bond.to ? symmetry : "1_555");
    }
    text += "\n";
  }
  return text;
}

const Atom& unknown_of(const Molecule& m) {
  for (const Atom& atom : m.atoms) {
    if (atom.residue_number == 302) return atom;
  }
  ADD_FAILURE() << "it is not there";
  return m.atoms.front();
}

// The same bonds in each of the three kinds of records, before and behind the atoms.
std::vector<Molecule> molecules_with(const std::vector<SampleAtom>& sample,
                                     const std::vector<Bond>& bonds) {
  std::string links, conects;
  for (const Bond& bond : bonds) {
    links += link(sample, bond);
    conects += text_of("CONECT%5d%5d\n", bond.from, bond.to);
  }
  std::vector<Molecule> result;
  result.push_back(read_text("a.pdb", links + as_pdb(sample)));
  result.push_back(read_text("a.pdb", as_pdb(sample, false) + conects));
  const std::string cif = as_mmcif(sample, {});
  result.push_back(read_text("a.cif", cif + struct_conn(sample, bonds, "covale")));
  return result;
}

void expect_unknown(const std::vector<SampleAtom>& sample, const std::vector<Bond>& bonds,
                    ResidueKind kind, Why why) {
  int records = 0;
  for (const Molecule& m : molecules_with(sample, bonds)) {
    EXPECT_EQ(unknown_of(m).kind, kind) << records << ' ' << reason_id(unknown_of(m).why);
    EXPECT_EQ(unknown_of(m).why, why) << records << ' ' << reason_id(unknown_of(m).why);
    EXPECT_EQ(m.atoms.front().kind, ResidueKind::polymer);
    ++records;
  }
}

// Bonds from C of GLY 1 (3) to N9 (9), and from C7 (10) to N of ALA 3 (5), in either direction.
TEST(RecordedBonds, OnBothSidesInTheChainMakeAPolymer) {
  const auto sample = torn_chain();
  expect_unknown(sample, {{3, 9}, {10, 5}}, ResidueKind::polymer, Why::bond_record);
  expect_unknown(sample, {{9, 3}, {5, 10}}, ResidueKind::polymer, Why::bond_record);
}

TEST(RecordedBonds, OnOneSideLeaveALigandAndSaySo) {
  const auto sample = torn_chain();
  expect_unknown(sample, {{3, 9}}, ResidueKind::ligand, Why::bound_ligand);
  expect_unknown(sample, {{10, 5}}, ResidueKind::ligand, Why::bound_ligand);
  // Bonds to CA and O, which are no ends of a residue, make a ligand that holds two residues
  // together.
  expect_unknown(sample, {{2, 9}, {10, 8}}, ResidueKind::ligand, Why::bound_ligand);
  EXPECT_FALSE(is_guess(Why::bound_ligand));
}

TEST(RecordedBonds, OfMetalsAndWithinAResidueTellNothing) {
  const auto sample = torn_chain();
  for (const auto& bonds : {std::vector<Bond>{}, {{3, 11}, {11, 5}}, {{9, 10}}}) {
    for (const Molecule& m : molecules_with(sample, bonds)) {
      EXPECT_EQ(unknown_of(m).kind, ResidueKind::ligand);
      EXPECT_TRUE(unknown_of(m).why == Why::hetatm || unknown_of(m).why == Why::after_ter);
    }
  }
}

// Chains of two letters use column 21 as well, in atoms and in LINK.
TEST(RecordedBonds, NameChainsOfTwoLetters) {
  const auto sample = torn_chain();
  const auto with_two_letters = [](std::string text) {
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin);
      std::string line = text.substr(begin, end - begin);
      if (line.starts_with("ATOM") || line.starts_with("HETATM")) line[20] = 'Z';
      if (line.starts_with("LINK")) line[20] = line[50] = 'Z';
      result += line + "\n";
      begin = end + 1;
    }
    return result;
  };
  const std::string links = link(sample, {3, 9}) + link(sample, {10, 5});
  const Molecule both = read_text("a.pdb", with_two_letters(links + as_pdb(sample)));
  EXPECT_EQ(both.text(unknown_of(both).chain), "ZA");
  EXPECT_EQ(unknown_of(both).why, Why::bond_record);
  const Molecule other = read_text("a.pdb", links + with_two_letters(as_pdb(sample)));
  EXPECT_NE(unknown_of(other).why, Why::bond_record) << "chain A is not there";
}

// A known ligand stays a ligand, for example a haem tied to the ends of a chain.
TEST(RecordedBonds, AKnownLigandStaysOne) {
  expect_unknown(torn_chain("NAG"), {{3, 9}, {10, 5}}, ResidueKind::ligand, Why::bound_ligand);
}

TEST(RecordedBonds, ToAnotherAsymmetricUnitAreNone) {
  const auto sample = torn_chain();
  const Molecule pdb = read_text(
      "a.pdb", link(sample, {3, 9}, "2655") + link(sample, {10, 5}, "2655") + as_pdb(sample));
  EXPECT_EQ(unknown_of(pdb).why, Why::after_ter);
  const std::vector<Bond> bonds{{3, 9}, {10, 5}};
  const std::string cif = as_mmcif(sample, {});
  EXPECT_EQ(unknown_of(read_text("a.cif", cif + struct_conn(sample, bonds, "covale", "2_655"))).why,
            Why::hetatm);
  EXPECT_EQ(unknown_of(read_text("a.cif", cif + struct_conn(sample, bonds, "metalc"))).why,
            Why::hetatm);
  EXPECT_EQ(
      unknown_of(read_text("a.cif", "data_o\n" + struct_conn(sample, bonds, "covale") + cif)).why,
      Why::hetatm)
      << "of another data block";
}

// Serial numbers that repeat, as in files that ran out of them, identify no atom.
TEST(RecordedBonds, ASerialNumberOfTwoAtomsNamesNone) {
  const auto sample = torn_chain();
  const std::string atom =
      "HETATM    9  O   HOH A 400       0.000  90.000   0.000  1.00 10.00           O\n";
  const Molecule m =
      read_text("a.pdb", atom + as_pdb(sample, false) + "CONECT    3    9\nCONECT   10    5\n");
  EXPECT_EQ(unknown_of(m).why, Why::bound_ligand) << "by the other bond";
}

// Bond records take precedence over places of atoms, but not over the entity table.
TEST(RecordedBonds, TheEntityTableGoesBeforeThem) {
  const auto sample = torn_chain();
  const std::string cif = as_mmcif(sample, {.entities = true, .numbers_polymers = true});
  const Molecule m = read_text("a.cif", cif + struct_conn(sample, {{3, 9}, {10, 5}}, "covale"));
  EXPECT_EQ(unknown_of(m).why, Why::entity_non_polymer);
}

// A bond that names a chain without atoms must not be taken for a bond of the chain without a name.
TEST(RecordedBonds, OfAChainThatIsNotThereTellNothing) {
  auto sample = torn_chain();
  auto elsewhere = sample;
  for (SampleAtom& atom : sample) atom.chain = ' ';
  for (SampleAtom& atom : elsewhere) atom.chain = 'Z';
  const auto why_with = [&](const std::vector<SampleAtom>& linked) {
    const std::string links = link(linked, {3, 9}) + link(linked, {10, 5});
    return unknown_of(read_text("a.pdb", links + as_pdb(sample))).why;
  };
  const Why without = unknown_of(read_text("a.pdb", as_pdb(sample))).why;
  EXPECT_EQ(why_with(elsewhere), without);
  EXPECT_NE(why_with(sample), without);
}

TEST(RecordedBonds, ALoopThatMixesTablesIsRead) {
  const Molecule m =
      read_text("a.cif",
                "data_A\nloop_\n_struct_conn.conn_type_id\n_short\ncovale 1\ncovale 2\nloop_\n"
                "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 2 3\n");
  EXPECT_EQ(m.atoms.size(), 1u);
}

}  // namespace
}  // namespace alphascope
