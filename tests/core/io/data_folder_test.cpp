// Every file of the data folder opens to the atom counts of the folder's README, or is refused as
// written below. The README is the table of this test.
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/molecule/prepare_balls.hpp"
#include "tests/core/io/temporary_file.hpp"

namespace alphascope {
namespace {

struct Row {
  std::string file, format;
  std::size_t atoms = 0, hetero = 0, models = 0;
};

// Files that must not open, with what the message must say.
const std::map<std::string, std::string> kRefused = {
    {"awkward/header_only.pdb", "no atoms"},
    {"awkward/empty.pdb", "no atoms"},
    {"awkward/empty_model.pdb", "no atoms"},
    {"awkward/6elw_26lines.ent", "no atoms"},
    {"awkward/1mom_min.cif", "no atom_site table"},
    {"awkward/4q9r_min.cif", "no atom_site table"},
    {"awkward/eol-test.cif", "no atom_site table"},
    {"awkward/misc.cif", "no atom_site table"},
    {"awkward/small_molecule_core.cif", "fractional"},
    {"awkward/small_molecule_1544173.cif", "fractional"},
    {"awkward/bad_count.xyz", "line 6: the atoms end after 4 of the 8"},
    {"awkward/bad_extended.xyz", "line 3: the line has 4 of the 5 fields"},
};

bool is_molecule_format(const std::string& format) {
  for (const char* start : {"PDB", "mmCIF", "CIF", "XYZ", "CRD", "PQR", "CHARMM"}) {
    if (format.starts_with(start)) return true;
  }
  return false;
}

std::vector<Row> read_table() {
  std::ifstream readme(test_data("README.md"));
  std::vector<Row> rows;
  std::string line;
  while (std::getline(readme, line)) {
    std::vector<std::string> cells;
    for (std::size_t at = line.find('|'); at != std::string::npos;) {
      const std::size_t next = line.find('|', at + 1);
      if (next == std::string::npos) break;
      const std::string cell = line.substr(at + 1, next - at - 1);
      const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
      at = next;
    }
    if (cells.size() < 7 || cells[0].find('/') == std::string::npos) continue;
    if (!is_molecule_format(cells[2])) continue;
    rows.push_back(
        {cells[0], cells[2], std::stoul(cells[3]), std::stoul(cells[4]), std::stoul(cells[5])});
  }
  return rows;
}

void check(const Row& row) {
  SCOPED_TRACE(row.file);
  const auto refused = kRefused.find(row.file);
  try {
    const Molecule m = read_molecule(test_data(row.file));
    ASSERT_EQ(refused, kRefused.end()) << "opened, though it should be refused";
    ASSERT_EQ(m.models.size(), row.models);
    std::size_t hetero = 0;
    for (std::size_t i = m.models[0].begin; i < m.models[0].end; ++i) hetero += m.atoms[i].hetero;
    // XYZR and PQR-of-spheres rows count all points as ATOM.
    EXPECT_EQ(hetero, row.hetero);
    EXPECT_EQ(m.models[0].size() - hetero, row.atoms);
    EXPECT_EQ(m.models.back().end, m.atoms.size());
  } catch (const ReadError& error) {
    ASSERT_NE(refused, kRefused.end()) << error.what();
    EXPECT_NE(std::string(error.what()).find(refused->second), std::string::npos) << error.what();
  }
}

TEST(DataFolder, EveryFileOpensToItsCountsOrIsRefusedAsDocumented) {
  ALPHASCOPE_NEED_TEST_DATA();
  const std::vector<Row> rows = read_table();
  EXPECT_GE(rows.size(), 150u);
  for (const Row& row : rows) check(row);
}

std::vector<std::pair<LatticePoint, Element>> sorted_atoms(const Molecule& m) {
  std::vector<std::pair<LatticePoint, Element>> atoms;
  for (const Atom& a : m.atoms) atoms.emplace_back(a.position, a.element);
  std::sort(atoms.begin(), atoms.end());
  return atoms;
}

TEST(DataFolder, WhateverElseLiesThereIsRefusedBySayingWhatItIs) {
  ALPHASCOPE_NEED_TEST_DATA();
  std::set<std::string> molecules;
  for (const Row& row : read_table()) molecules.insert(row.file);
  std::size_t others = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(testing::test_data_folder())) {
    if (!entry.is_regular_file()) continue;
    const std::string name =
        std::filesystem::relative(entry.path(), testing::test_data_folder()).string();
    if (molecules.contains(name)) continue;
    ++others;
    try {
      read_molecule(entry.path());
      ADD_FAILURE() << name << " opened, though it is in no table of molecules";
    } catch (const ReadError& error) {
      EXPECT_NE(error.reason().find("it looks like"), std::string::npos) << error.what();
    }
  }
  EXPECT_GE(others, 20u);
}

// x, y, z and radius of every ball on the lattice of that many digits, which holds them exactly.
std::vector<std::array<int, 4>> balls_at(const Molecule& m, const BallOptions& options,
                                         int digits) {
  const PreparedBalls prepared = prepare_balls(m, options);
  EXPECT_LE(prepared.balls->lattice.digits, digits);
  int factor = 1;
  for (int d = prepared.balls->lattice.digits; d < digits; ++d) factor *= 10;
  std::vector<std::array<int, 4>> result;
  for (std::size_t i = 0; i < prepared.balls->size(); ++i) {
    const LatticePoint& p = prepared.balls->centres[i];
    result.push_back({p.x * factor, p.y * factor, p.z * factor, prepared.balls->radii[i] * factor});
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(DataFolder, TheSameMoleculeInOtherFormatsHasTheSameAtoms) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule pdb = read_molecule(test_data("ladder/adk_open.pdb.gz"));
  const Molecule card = read_molecule(test_data("ladder/adk_open.crd.gz"));
  ASSERT_EQ(pdb.atoms.size(), card.atoms.size());
  EXPECT_EQ(pdb.lattice, card.lattice);
  for (std::size_t i = 0; i < pdb.atoms.size(); ++i) {
    ASSERT_EQ(pdb.atoms[i].position, card.atoms[i].position) << i;
    ASSERT_EQ(pdb.atoms[i].element, card.atoms[i].element) << i;
    ASSERT_EQ(pdb.text(pdb.atoms[i].name), card.text(card.atoms[i].name)) << i;
    ASSERT_EQ(pdb.atoms[i].residue_number, card.atoms[i].residue_number) << i;
  }
  // The same atoms as PQR; but 24 hydrogens were built anew there, and some atoms come in another
  // order.
  const Molecule pqr = read_molecule(test_data("ladder/adk_open.pqr.gz"));
  BallOptions bondi;
  bondi.radii = RadiiSet::bondi;
  bondi.hydrogens = HydrogenRule::drop;
  for (const Molecule* other : {&card, &pqr}) {
    EXPECT_TRUE(balls_at(pdb, bondi, 4) == balls_at(*other, bondi, 4)) << other->format;
  }
  // PDB formats 2.3 and 3.0, without and with the element column.
  const Molecule old_format = read_molecule(test_data("awkward/104d_v23.pdb"));
  const Molecule new_format = read_molecule(test_data("awkward/104d_v30.pdb"));
  EXPECT_EQ(sorted_atoms(old_format), sorted_atoms(new_format)) << "the order differs";
  const Molecule plain = read_molecule(test_data("awkward/1a8o.pdb"));
  const Molecule balls = read_molecule(test_data("awkward/1a8o.xyzr"));
  ASSERT_EQ(plain.atoms.size(), balls.atoms.size());
  for (std::size_t i = 0; i < plain.atoms.size(); ++i) {
    ASSERT_EQ(plain.atoms[i].position, balls.atoms[i].position) << i;
  }
}

}  // namespace
}  // namespace alphascope
