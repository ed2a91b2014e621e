// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that every file of the data folder opens with the atom counts in its README, or is refused
// as listed below.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/core/read/data_table.hpp"

namespace alphascope {
namespace {

// Files that must not open, with a part of the message.
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

std::vector<DataRow> rows_of(bool molecules) {
  std::vector<DataRow> rows = data_table();
  std::erase_if(rows, [&](const DataRow& row) { return row.molecule != molecules; });
  return rows;
}

void check(const DataRow& row) {
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
  const std::vector<DataRow> rows = rows_of(true);
  EXPECT_GE(rows.size(), 150u);
  for (const DataRow& row : rows) check(row);
}

std::vector<std::pair<LatticePoint, Element>> sorted_atoms(const Molecule& m) {
  std::vector<std::pair<LatticePoint, Element>> atoms;
  for (const Atom& a : m.atoms) atoms.emplace_back(a.position, a.element);
  std::sort(atoms.begin(), atoms.end());
  return atoms;
}

TEST(DataFolder, WhatIsNoMoleculeThereIsRefusedBySayingWhatItIs) {
  ALPHASCOPE_NEED_TEST_DATA();
  const std::vector<DataRow> rows = rows_of(false);
  EXPECT_GE(rows.size(), 20u);
  for (const DataRow& row : rows) {
    try {
      read_molecule(test_data(row.file));
      ADD_FAILURE() << row.file << " opened, though it is no molecule";
    } catch (const ReadError& error) {
      EXPECT_NE(error.reason().find("it looks like"), std::string::npos) << error.what();
    }
  }
}

// x, y, z and radius of every ball, on a lattice of `digits` that holds them exactly.
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
  // The same atoms as PQR. 24 hydrogens were rebuilt there, and some atoms have another order.
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
