// SPDX-License-Identifier: GPL-3.0-or-later
// Tests twins of one structure by different programs and in different formats. All have the same
// polymer, ligand, ion and water atoms, elements, radii and cavities.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/molecule/residue_reason.hpp"
#include "core/predicates/wide_int.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/core/read/twin_dialects.hpp"

namespace alphascope {
namespace {

struct Twin {
  const char *dialect, *file, *format;
  std::string text;
};

std::string without_elements(const std::string& pdb) {
  std::string text;
  for (std::size_t begin = 0; begin < pdb.size();) {
    const std::size_t end = pdb.find('\n', begin);
    text += pdb.substr(begin, std::min<std::size_t>(end - begin, 66)) + "\r\n";
    begin = end + 1;
  }
  return text;
}

// SEQRES and MODRES records of the sample.
std::string sequence_records() {
  return "HEADER    A TWIN\n"
         "SEQRES   1 A    5  ACE GLY ZQ2 ALA NH2\n"
         "SEQRES   1 B    2   DA  DT\n"
         "SEQRES   1 C    8  ALA ALA ALA ALA ALA ALA ALA ALA\n"
         "MODRES TWIN ZQ2 A    2  GLY\n";
}

CifProgram deposited_cif() {
  return {.tags = {"group_PDB",         "id",
                   "type_symbol",       "label_atom_id",
                   "label_alt_id",      "label_comp_id",
                   "label_asym_id",     "label_entity_id",
                   "label_seq_id",      "pdbx_PDB_ins_code",
                   "Cartn_x",           "Cartn_y",
                   "Cartn_z",           "occupancy",
                   "B_iso_or_equiv",    "pdbx_formal_charge",
                   "auth_seq_id",       "auth_comp_id",
                   "auth_asym_id",      "auth_atom_id",
                   "pdbx_PDB_model_num"},
          .before = kTwinEntities};
}

CifProgram gemmis() {
  CifProgram program = deposited_cif();
  program.tags = {"group_PDB",         "id",
                  "type_symbol",       "label_atom_id",
                  "label_alt_id",      "label_comp_id",
                  "label_asym_id",     "label_entity_id",
                  "label_seq_id",      "pdbx_PDB_ins_code",
                  "Cartn_x",           "Cartn_y",
                  "Cartn_z",           "occupancy",
                  "B_iso_or_equiv",    "pdbx_formal_charge",
                  "auth_seq_id",       "auth_asym_id",
                  "pdbx_PDB_model_num"};
  program.mixed_case = true;
  return program;
}

// No table of entities, and a label_seq_id for every atom.
CifProgram pymols() {
  return {.tags = {"group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id",
                   "label_comp_id", "label_asym_id", "label_entity_id", "label_seq_id",
                   "pdbx_PDB_ins_code", "Cartn_x", "Cartn_y", "Cartn_z", "occupancy",
                   "B_iso_or_equiv", "pdbx_formal_charge", "auth_asym_id", "pdbx_PDB_model_num"},
          .own_asym = false,
          .entities = false,
          .numbers_all = true};
}

// Numbered entities without a table of their types.
CifProgram phenixs() {
  return {.tags = {"group_PDB", "id", "label_atom_id", "label_alt_id", "label_comp_id",
                   "auth_asym_id", "auth_seq_id", "pdbx_PDB_ins_code", "Cartn_x", "Cartn_y",
                   "Cartn_z", "occupancy", "B_iso_or_equiv", "type_symbol", "pdbx_formal_charge",
                   "label_asym_id", "label_entity_id", "label_seq_id", "pdbx_PDB_model_num"},
          .indent = "  ",
          .mixed_case = true};
}

CifProgram alphafolds() {
  CifProgram program = deposited_cif();
  program.behind =
      "#\nloop_\n_ma_qa_metric.id\n_ma_qa_metric.mode\n_ma_qa_metric.name\n"
      "_ma_qa_metric.type\n1 global pLDDT pLDDT\n2 local pLDDT pLDDT\n#\n";
  program.b_factor = "91.29";
  return program;
}

// Neither chains nor HETATM. The chain's number is the entity.
CifProgram open_babels() {
  return {.tags = {"id", "type_symbol", "label_atom_id", "label_comp_id", "label_entity_id",
                   "label_seq_id", "Cartn_x", "Cartn_y", "Cartn_z"},
          .between = "\t",
          .chain_as_entity = true,
          .numbers_all = true,
          .mixed_case = true};
}

std::vector<Twin> twins_of(const std::vector<SampleAtom>& sample) {
  CifProgram gemmi_alone = gemmis();
  gemmi_alone.before = "";
  return {
      {"PDB", "a.pdb", "PDB", as_pdb(sample)},
      {"PDB as deposited", "a.pdb", "PDB", sequence_records() + as_pdb(sample)},
      {"PDB without TER", "a.pdb", "PDB", as_pdb(sample, false)},
      {"PDB without elements", "a.pdb", "PDB", without_elements(as_pdb(sample))},
      {"PDBQT", "a.pdbqt", "PDBQT", as_pdbqt(sample)},
      {"PDBQT named .pdb", "a.pdb", "PDBQT", as_pdbqt(sample)},
      {"PQR", "a.pqr", "PQR", as_pqr(sample)},
      {"PQR of PDB2PQR, without chains", "a.pqr", "PQR", as_pqr_without_chains(sample)},
      {"PQR of Open Babel", "a.pqr", "PQR", as_pqr_of_open_babel(sample)},
      {"mmCIF as deposited", "a.cif", "mmCIF", as_cif(sample, deposited_cif())},
      {"mmCIF of gemmi", "a.cif", "mmCIF", as_cif(sample, gemmis())},
      {"mmCIF of gemmi without entities", "a.cif", "mmCIF", as_cif(sample, gemmi_alone)},
      {"mmCIF of PyMOL", "a.cif", "mmCIF", as_cif(sample, pymols())},
      {"mmCIF of Phenix", "a.cif", "mmCIF", as_cif(sample, phenixs())},
      {"mmCIF of AlphaFold", "a.cif", "mmCIF", as_cif(sample, alphafolds())},
  };
}

// For programs that write no HETATM. A ligand is then guessed, and a free glycine looks like part
// of a chain, so it is left out here.
std::vector<SampleAtom> without_free_glycine() {
  std::vector<SampleAtom> sample = twin_sample();
  std::erase_if(sample, [](const SampleAtom& a) { return a.number == 302; });
  return sample;
}

std::vector<Twin> twins_without_hetatm(const std::vector<SampleAtom>& sample) {
  return {{"PDBQT, all ATOM", "a.pdbqt", "PDBQT", as_pdbqt(sample, false)},
          {"mmCIF of Open Babel", "a.cif", "mmCIF", as_cif(sample, open_babels())}};
}

void expect_kinds(const Twin& twin, const Molecule& m, const std::vector<SampleAtom>& sample) {
  EXPECT_EQ(m.format, twin.format) << twin.dialect;
  EXPECT_EQ(m.models.size(), 1u) << twin.dialect;
  ASSERT_EQ(m.atoms.size(), sample.size()) << twin.dialect;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Atom& atom = m.atoms[i];
    const std::string where = std::string(twin.dialect) + ": " + sample[i].residue + " " +
                              std::to_string(sample[i].number) + " " + sample[i].name + ", " +
                              reason_text(atom.why);
    EXPECT_EQ(atom.kind, sample[i].kind) << where;
    EXPECT_EQ(atom.element, element_from_symbol(sample[i].element)) << where;
    EXPECT_EQ(m.text(atom.name), sample[i].name) << where;
    EXPECT_EQ(m.text(atom.residue_name), sample[i].residue) << where;
    EXPECT_EQ(atom.residue_number, sample[i].number) << where;
    EXPECT_NEAR(m.lattice.angstrom(atom.position.y), sample[i].y, 1e-9) << where;
  }
}

// The radius of each atom (10^-6 Å) in this set, whatever the file has. -1 where it gets no ball.
std::vector<std::int64_t> radii_of(const Molecule& m, RadiiSet set) {
  BallOptions options;
  options.radii = set;
  options.waters = true;
  const PreparedBalls prepared = prepare_balls(m, options);
  std::vector<std::int64_t> result(m.atoms.size(), -1);
  for (std::size_t k = 0; k < prepared.atom_of_ball.size(); ++k) {
    const double radius = prepared.balls->lattice.angstrom(prepared.balls->radii[k]);
    result[prepared.atom_of_ball[k]] = static_cast<std::int64_t>(radius * 1e6 + 0.5);
  }
  return result;
}

// CASTp's radii as in its tables: atoms of the polymer by their types.
std::int64_t castp_radius(const SampleAtom& a) {
  const std::string_view name = a.name;
  if (name == "CA") return 1880000;
  if (name == "C") return 1610000;
  if (name == "N") return 1640000;
  return name == "O" ? 1420000 : 0;
}

CavityTable castps_cavities(const Molecule& m) {
  constexpr double kSolvent = 1.4;  // Å
  BallOptions body;
  body.radii = RadiiSet::castp;
  body.ligands = body.ions = false;
  const PreparedBalls prepared = prepare_balls(m, body);
  const auto balls = std::make_shared<const BallSet>(with_solvent(*prepared.balls, kSolvent));
  const auto triangulation = std::make_shared<const Triangulation>(make_triangulation(*balls, 1));
  const auto ground =
      std::make_shared<const CavityGround>(make_cavity_ground(balls, triangulation));
  return make_cavity_table(ground, {.alpha_angstrom2 = 0.0, .solvent_radius_angstrom = kSolvent});
}

// Eight balls of 1.88 + 1.4 Å at the corners of a cube of 4.2 Å. Faces are closed (half a diagonal
// is 2.97 Å), and the middle is free (3.64 Å). Volume and area of the free part, by integration
// over one corner.
constexpr double kVoidVolume = 0.346103740871926, kVoidArea = 3.01601225753098;

void expect_cavities(const char* dialect, const CavityTable& table, const CavityTable& first) {
  EXPECT_EQ(table.voids, 1u) << dialect;
  EXPECT_NEAR(table.volume_sa_angstrom3(true), kVoidVolume, 1e-9) << dialect;
  EXPECT_NEAR(table.area_sa_angstrom2(true), kVoidArea, 1e-9) << dialect;
  EXPECT_EQ(table.pockets, first.pockets) << dialect;
  EXPECT_EQ(table.mouths, first.mouths) << dialect;
  ASSERT_EQ(table.size(), first.size()) << dialect;
  for (std::size_t row = 0; row < table.size(); ++row) {
    EXPECT_NEAR(table.measure(row).volume_sa_angstrom3, first.measure(row).volume_sa_angstrom3,
                1e-9)
        << dialect;
    EXPECT_NEAR(table.measure(row).volume_ms_angstrom3, first.measure(row).volume_ms_angstrom3,
                1e-9)
        << dialect;
    EXPECT_EQ(table.measure(row).lining, first.measure(row).lining) << dialect;
  }
}

TEST(Twins, HaveTheSameResiduesAndElements) {
  const std::vector<SampleAtom> sample = twin_sample();
  for (const Twin& twin : twins_of(sample)) {
    const Molecule m = read_text(twin.file, twin.text);
    expect_kinds(twin, m, sample);
    for (const Atom& atom : m.atoms) {
      EXPECT_FALSE(is_guess(atom.why)) << twin.dialect << ", line " << atom.source_line;
    }
    EXPECT_EQ(m.has_confidences, twin.dialect == std::string("mmCIF of AlphaFold"));
  }
}

TEST(Twins, WithoutHetatmHaveThemByAGuess) {
  const std::vector<SampleAtom> sample = without_free_glycine();
  for (const Twin& twin : twins_without_hetatm(sample)) {
    const Molecule m = read_text(twin.file, twin.text);
    expect_kinds(twin, m, sample);
    for (std::size_t i = 0; i < m.atoms.size() && i < sample.size(); ++i) {
      EXPECT_EQ(is_guess(m.atoms[i].why), sample[i].kind == ResidueKind::ligand) << twin.dialect;
    }
  }
}

TEST(Twins, HaveTheSameRadii) {
  const std::vector<SampleAtom> sample = twin_sample();
  const std::vector<Twin> twins = twins_of(sample);
  const RadiiSet sets[] = {RadiiSet::bondi, RadiiSet::protor,  RadiiSet::castp, RadiiSet::alvarez,
                           RadiiSet::amber, RadiiSet::naccess, RadiiSet::rasmol};
  const Molecule first = read_text(twins[0].file, twins[0].text);
  for (const Twin& twin : twins) {
    const Molecule m = read_text(twin.file, twin.text);
    for (const RadiiSet set : sets) {
      EXPECT_EQ(radii_of(m, set), radii_of(first, set))
          << twin.dialect << ' ' << radii_set_info(set).id;
    }
  }
  const std::vector<std::int64_t> castps = radii_of(first, RadiiSet::castp);
  std::size_t known = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::string_view residue = sample[i].residue;
    if (residue != "ALA" && residue != "GLY") continue;
    if (sample[i].kind != ResidueKind::polymer) continue;
    EXPECT_EQ(castps[i], castp_radius(sample[i])) << residue << ' ' << sample[i].name;
    ++known;
  }
  EXPECT_EQ(known, 16u);
}

TEST(Twins, KeepTheRadiiThatTheirFormatHas) {
  for (const Twin& twin : twins_of(twin_sample())) {
    const Molecule m = read_text(twin.file, twin.text);
    const bool pqr = twin.format == std::string("PQR");
    const bool open_babel = twin.dialect == std::string("PQR of Open Babel");
    EXPECT_EQ(m.has_file_radii, pqr) << twin.dialect;
    for (const Atom& atom : m.atoms) {
      const double radius = atom.file_radius < 0 ? -1 : m.lattice.angstrom(atom.file_radius);
      const double right = !pqr ? -1 : open_babel ? 1.7 : 1.5;
      EXPECT_NEAR(radius, right, 1e-9) << twin.dialect;
    }
  }
}

TEST(Twins, HaveTheSameCavities) {
  std::vector<Twin> twins = twins_of(twin_sample());
  // The free glycine is not part of the body.
  for (Twin& twin : twins_without_hetatm(without_free_glycine())) twins.push_back(std::move(twin));
  const CavityTable first = castps_cavities(read_text(twins[0].file, twins[0].text));
  for (const Twin& twin : twins) {
    expect_cavities(twin.dialect, castps_cavities(read_text(twin.file, twin.text)), first);
  }
}

// Two chains with equal residue numbers, side by side in a file without chain names.
TEST(Twins, OfOpenBabelKeepTheirChainsApart) {
  const std::vector<SampleAtom> sample{
      {"O", "O", "HOH", 'A', 1, 0, 0, 0, true, ResidueKind::water, "1"},
      {"O", "O", "HOH", 'B', 1, 9, 0, 0, true, ResidueKind::water, "1"}};
  const Molecule m = read_text("a.cif", as_cif(sample, open_babels()));
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.text(m.atoms[0].chain), "1");
  EXPECT_EQ(m.text(m.atoms[1].chain), "2");
  EXPECT_EQ(m.text(m.atoms[1].label_chain), "2");
}

}  // namespace
}  // namespace alphascope
