// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what residues are and why: evidence in its order, and the same answers in all dialects.
#include <algorithm>
#include <string>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/residue_reason.hpp"
#include "core/selection/residue_list.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/core/read/residue_dialects.hpp"

namespace alphascope {
namespace {

using Why = ResidueReason;

// The first atom of the residue with this number.
const Atom& residue(const Molecule& m, int number, const char* name = nullptr) {
  for (const Atom& atom : m.atoms) {
    if (atom.residue_number == number && (!name || m.text(atom.residue_name) == name)) return atom;
  }
  ADD_FAILURE() << "no residue " << number;
  return m.atoms.front();
}

bool says(const Molecule& m, const std::string& text) {
  return std::any_of(m.notes.begin(), m.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

void expect_sample(const Molecule& m, const std::vector<SampleAtom>& sample, const char* dialect) {
  ASSERT_EQ(m.atoms.size(), sample.size()) << dialect;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::string where = std::string(dialect) + ": " + sample[i].residue + " " +
                              std::to_string(sample[i].number) + " " + sample[i].name + ", " +
                              reason_text(m.atoms[i].why);
    EXPECT_EQ(m.atoms[i].kind, sample[i].kind) << where;
    EXPECT_EQ(m.atoms[i].element, element_from_symbol(sample[i].element)) << where;
    EXPECT_FALSE(is_guess(m.atoms[i].why)) << where;
  }
}

TEST(Residues, AreTheSameInEveryDialect) {
  const std::vector<SampleAtom> sample = residue_sample();
  expect_sample(read_text("a.pdb", as_pdb(sample)), sample, "PDB");
  expect_sample(read_text("a.pdb", as_pdb(sample, false)), sample, "PDB without TER");
  expect_sample(read_text("a.pqr", as_pqr(sample)), sample, "PQR");
  expect_sample(read_text("a.cif", as_mmcif(sample, {.entities = true, .numbers_polymers = true})),
                sample, "mmCIF as deposited");
  expect_sample(read_text("a.cif", as_mmcif(sample, {.numbers_all = true, .author = false})),
                sample, "mmCIF of PyMOL");
  expect_sample(read_text("a.cif", as_mmcif(sample, {.numbers_polymers = true})), sample,
                "mmCIF of gemmi without entities");
  expect_sample(read_text("a.cif", as_mmcif(sample, {.entities = true, .numbers_all = true})),
                sample, "mmCIF of AlphaFold");
  expect_sample(read_text("a.cif", as_mmcif(sample, {})), sample, "mmCIF of Phenix");
}

// Open Babel writes no HETATM. A ligand is then guessed from its own atoms, with a note.
TEST(Residues, AreToldWithoutHetatm) {
  std::vector<SampleAtom> sample = residue_sample();
  std::erase_if(sample, [](const SampleAtom& a) { return a.number == 302; });
  const Molecule m =
      read_text("a.cif", as_mmcif(sample, {.numbers_all = true, .group = false, .author = false}));
  ASSERT_EQ(m.atoms.size(), sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i) {
    EXPECT_EQ(m.atoms[i].kind, sample[i].kind) << sample[i].residue << ' ' << sample[i].name;
  }
  EXPECT_EQ(residue(m, 301).why, Why::no_polymer);
  EXPECT_TRUE(says(m, "ligands by a guess")) << "and which";
  EXPECT_TRUE(says(m, "1 residue (A:LQ9 301)"));
}

TEST(Residues, TheEntityTableGoesBeforeNumbersAndNames) {
  const std::string text =
      "data_t\nloop_\n_entity.id\n_entity.type\n1 polymer\n2 non-polymer\n3 water\n4 branched\n"
      "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
      "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_entity_id\n"
      "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "ATOM N N GLY A 1 1 0 0 0\nHETATM C C1 QQQ A 1 2 5 0 0\nATOM C C1 LG1 C 2 1 10 0 0\n"
      "ATOM C C1 NAG D 4 1 20 0 0\nATOM C CA ALA E 2 7 30 0 0\nATOM O O W4X F 3 8 40 0 0\n"
      "HETATM FE FE HEM G 2 201 50 0 0\nHETATM ZN ZN ZN H 2 202 60 0 0\n"
      "HETATM O O HOH A 1 9 70 0 0\nHETATM O O W4X H 2 203 80 0 0\n";
  const Molecule m = read_text("a.cif", text);
  const std::pair<ResidueKind, Why> right[] = {
      {ResidueKind::polymer, Why::entity_polymer},    {ResidueKind::polymer, Why::entity_polymer},
      {ResidueKind::ligand, Why::entity_non_polymer}, {ResidueKind::ligand, Why::entity_branched},
      {ResidueKind::ligand, Why::entity_non_polymer}, {ResidueKind::water, Why::entity_water},
      {ResidueKind::ligand, Why::entity_non_polymer}, {ResidueKind::ion, Why::ion_name},
      {ResidueKind::water, Why::water_name},          {ResidueKind::water, Why::one_oxygen}};
  ASSERT_EQ(m.atoms.size(), std::size(right));
  for (std::size_t i = 0; i < std::size(right); ++i) {
    EXPECT_EQ(m.atoms[i].kind, right[i].first) << i;
    EXPECT_EQ(m.atoms[i].why, right[i].second) << i << reason_id(m.atoms[i].why);
  }
  EXPECT_TRUE(says(m,
                   "The entity table says polymer, but by their own atoms they are water: 1 "
                   "residue (A:HOH 9)"));
}

TEST(Residues, EntitiesAreFoundByChainAndAfterTheAtoms) {
  const Molecule m = read_text(
      "a.cif",
      "data_t\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
      "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.Cartn_x\n"
      "_atom_site.Cartn_y\n_atom_site.Cartn_z\nATOM C C1 AAA A 0 0 0\nHETATM C C1 BBB B 9 0 0\n"
      "loop_\n_struct_asym.id\n_struct_asym.entity_id\nA 2\nB 1\n"
      "loop_\n_entity_poly.entity_id\n_entity_poly.type\n1 'polypeptide(L)'\n"
      "_pdbx_entity_nonpoly.entity_id 2\n_pdbx_entity_nonpoly.comp_id AAA\n");
  EXPECT_EQ(m.atoms[0].why, Why::entity_non_polymer);
  EXPECT_EQ(m.atoms[1].why, Why::entity_polymer);
}

// Free amino acids of four atoms, away from chains, with TER records and without.
TEST(Residues, FreeAminoAcidsAreLigands) {
  std::vector<SampleAtom> sample;
  add_amino_acid(sample, "THR", 'A', 1, 0, 0);
  add_amino_acid(sample, "CYS", 'A', 2, 3.8, 0);
  for (const auto& [name, chain, number] :
       {std::tuple("GLY", 'A', 201), std::tuple("GLU", 'A', 202), std::tuple("TYR", 'C', 203)}) {
    add_amino_acid(sample, name, chain, number, 0, 10.0 * number, true, ResidueKind::ligand, "3");
  }
  for (const bool ter : {true, false}) {
    const Molecule m = read_text("a.pdb", as_pdb(sample, ter));
    for (std::size_t i = 0; i < sample.size(); ++i) {
      EXPECT_EQ(m.atoms[i].kind, sample[i].kind) << ter << ' ' << i;
    }
    EXPECT_EQ(residue(m, 201).why, ter ? Why::after_ter : Why::hetatm);
  }
}

TEST(Residues, ModifiedResiduesBelongToTheirChain) {
  std::vector<SampleAtom> sample;
  add_amino_acid(sample, "QA1", 'A', 1, 0, 0, true);  // bound to the next one
  add_amino_acid(sample, "ALA", 'A', 2, 3.8, 0);
  add_amino_acid(sample, "QA4", 'A', 4, 30, 0, true);  // between gaps
  add_amino_acid(sample, "ALA", 'A', 6, 60, 0);
  add_amino_acid(sample, "GLY", 'A', 7, 63.8, 0);
  const Molecule m = read_text("a.pdb", as_pdb(sample));
  for (const Atom& atom : m.atoms)
    EXPECT_EQ(atom.kind, ResidueKind::polymer) << reason_id(atom.why);
  EXPECT_EQ(residue(m, 1).why, Why::chain_bond);
  EXPECT_EQ(residue(m, 4).why, Why::place_in_chain);
  // A chromophore has other atom names, but the bonds.
  sample.clear();
  add_amino_acid(sample, "ALA", 'A', 1, 0, 0);
  sample.push_back({"N1", "N", "QRO", 'A', 2, 3.8, 0, 0, true});
  sample.push_back({"C3", "C", "QRO", 'A', 2, 6.27, 0, 0, true});
  add_amino_acid(sample, "ALA", 'A', 5, 7.6, 0);
  EXPECT_EQ(residue(read_text("a.pdb", as_pdb(sample)), 2).why, Why::chain_bond);
}

// In files made by hand residues are far apart, so their numbers decide. D-amino acids and caps.
TEST(Residues, NumbersTellWhereNothingIsBound) {
  std::vector<SampleAtom> sample;
  add_amino_acid(sample, "DAL", 'A', 1, 0, 0, true);
  add_amino_acid(sample, "QQ1", 'A', 2, 20, 0, true);
  sample.push_back({"C", "C", "FOR", 'A', 3, 40, 0, 0, true});
  sample.push_back({"N", "N", "NH2", 'A', 4, 60, 0, 0, true});
  const Molecule m = read_text("a.pdb", as_pdb(sample));
  for (const Atom& atom : m.atoms)
    EXPECT_EQ(atom.kind, ResidueKind::polymer) << reason_id(atom.why);
}

TEST(Residues, ModelsOfFewAtomsAreChains) {
  std::vector<SampleAtom> sample;
  for (int k = 1; k < 4; ++k) {
    sample.push_back({"CA", "C", "QAA", 'A', k, 3.8 * k, 0, 0, true});
  }
  const Molecule m = read_text("a.pdb", as_pdb(sample));
  for (const Atom& atom : m.atoms)
    EXPECT_EQ(atom.kind, ResidueKind::polymer) << reason_id(atom.why);
}

TEST(Residues, AtomRecordsOfNoPolymerAreLigandsAndSaid) {
  std::vector<SampleAtom> sample;
  add_amino_acid(sample, "ALA", 'A', 1, 0, 0);
  add_amino_acid(sample, "ALA", 'A', 2, 3.8, 0);
  for (const auto& [name, number] : {std::pair("QIG", 10), std::pair("UNK", 20)}) {
    sample.push_back({"C1", "C", name, 'A', number, 1.0 * number, 20, 0});
    sample.push_back({"O3", "O", name, 'A', number, 1.2 + number, 20, 0});
  }
  const Molecule m = read_text("a.pdb", as_pdb(sample));
  EXPECT_EQ(residue(m, 1).kind, ResidueKind::polymer);
  for (const int number : {10, 20}) {
    EXPECT_EQ(residue(m, number).kind, ResidueKind::ligand);
    EXPECT_EQ(residue(m, number).why, Why::no_polymer);
  }
  EXPECT_TRUE(says(m, "2 residues (A:QIG 10, A:UNK 20)"));
}

TEST(Residues, OneOxygenIsWaterWhateverItsName) {
  for (const char* name : {"T3P", "T4P", "TP5", "SW4", "FB3", "HH0", "OHH", "D2O", "MTO", "QZ3"}) {
    std::vector<SampleAtom> sample;
    sample.push_back({"O", "O", name, 'W', 1, 0, 0, 0});
    sample.push_back({"H1", "H", name, 'W', 1, 0.96, 0, 0});
    sample.push_back({"H2", "D", name, 'W', 1, -0.24, 0.93, 0});
    const Molecule m = read_text("a.pdb", as_pdb(sample));
    for (const Atom& atom : m.atoms) EXPECT_EQ(atom.kind, ResidueKind::water) << name;
  }
  // Methanol and hydroxide are no water.
  std::vector<SampleAtom> others;
  others.push_back({"C", "C", "QZ3", 'W', 1, 1.4, 0, 0, true, ResidueKind::ligand});
  others.push_back({"O", "O", "QZ3", 'W', 1, 0, 0, 0, true, ResidueKind::ligand});
  others.push_back({"O", "O", "OH", 'W', 2, 9, 0, 0, true, ResidueKind::ligand});
  for (const Atom& atom : read_text("a.pdb", as_pdb(others)).atoms) {
    EXPECT_EQ(atom.kind, ResidueKind::ligand);
  }
}

TEST(Residues, OneMetalIsAnIon) {
  std::vector<SampleAtom> sample{{"ZN", "ZN", "QZN", 'A', 1, 0, 0, 0, true, ResidueKind::ion},
                                 {"FE", "FE", "HEM", 'A', 2, 9, 0, 0, true, ResidueKind::ligand}};
  const Molecule m = read_text("a.pdb", as_pdb(sample));
  EXPECT_EQ(m.atoms[0].why, Why::one_metal);
  EXPECT_EQ(m.atoms[1].kind, ResidueKind::ligand) << "a haem of which one atom is seen";
}

TEST(Residues, ModelsOfTheSameAtomsGetTheSameAnswers) {
  std::vector<SampleAtom> sample;
  add_amino_acid(sample, "ALA", 'A', 1, 0, 0);
  add_amino_acid(sample, "QQ2", 'A', 2, 3.8, 0, true);
  std::string text = as_pdb(sample);
  text.resize(text.size() - 4);
  for (std::size_t i = 4; i < sample.size(); ++i) sample[i].x += 30;  // torn off
  std::string torn = as_pdb(sample);
  const Molecule m =
      read_text("a.pdb", "MODEL 1\n" + text + "ENDMDL\nMODEL 2\n" + torn + "ENDMDL\n");
  ASSERT_EQ(m.models.size(), 2u);
  for (const Atom& atom : m.atoms) EXPECT_EQ(atom.kind, ResidueKind::polymer);
}

// Two residue types at one place, whose atoms alternate.
TEST(Residues, AlternativeTypesAreOneEach) {
  std::string text;
  const char* names[] = {" N  ", " CA ", " C  ", " O  "};
  std::vector<SampleAtom> first, second;
  add_amino_acid(first, "QQ2", 'A', 2, 3.8, 0, true);
  add_amino_acid(second, "QQ3", 'A', 2, 3.8, 0, true);
  std::vector<SampleAtom> before;
  add_amino_acid(before, "ALA", 'A', 1, 0, 0);
  text = as_pdb(before);
  text.resize(text.size() - 4);
  for (int k = 0; k < 4; ++k) {
    for (int type = 0; type < 2; ++type) {
      const SampleAtom& a = (type ? second : first)[static_cast<std::size_t>(k)];
      text += text_of("HETATM%5d %s%c%s A   2    %8.3f%8.3f%8.3f  0.50 10.00           %s\n",
                      k + 10, names[k], type ? 'B' : 'A', a.residue, a.x, a.y, a.z, a.element);
    }
  }
  for (const Atom& atom : read_text("a.pdb", text).atoms) {
    EXPECT_EQ(atom.kind, ResidueKind::polymer) << reason_id(atom.why);
  }
}

TEST(Residues, AreListedInGroups) {
  const Molecule m = read_text("a.pdb", as_pdb(residue_sample()));
  const auto list = list_residues(m, 0, m.atoms.size(), ResidueListing::grouped);
  ASSERT_EQ(list.size(), 7u);
  EXPECT_EQ(list[0].chain, "A");
  EXPECT_EQ(list[0].number, "0-4");
  EXPECT_EQ(list[0].residues, 5u);
  EXPECT_EQ(list[0].atoms, 15u);
  EXPECT_EQ(list[2].name, "LQ9");
  EXPECT_EQ(list[3].why, Why::after_ter);
  EXPECT_EQ(list_residues(m, 0, m.atoms.size(), ResidueListing::each).size(), 12u);
}

}  // namespace
}  // namespace alphascope
