// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that atoms, hydrogens, classes and positions of every PDB and mmCIF file agree with gemmi's
// readers, where these read the file.
#include <algorithm>
#include <cmath>
#include <gemmi/cif.hpp>
#include <gemmi/gz.hpp>
#include <gemmi/mmread.hpp>
#include <gemmi/polyheur.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/geometry/lattice_point.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/core/read/data_table.hpp"

namespace alphascope {
namespace {

// Files that gemmi 0.5.7 reads differently, and why this program does not read them so.
const std::set<std::string> kGemmiDiffers = {
    "pbc_resid_overflow.pdb.gz",  // takes cut digits where columns are shifted right
    "end-endmdl.pdb",             // stops at the first END; another model follows
    // without an element column, takes HB1 and the like for no hydrogen
    "adk_open.pdb.gz", "5dfr_solvated.pdb.gz"};

// Larger files are of the same kinds. gemmi is not optimised here, and would take half of its time
// for them.
constexpr std::size_t kMostAtoms = 50'000;

// Files where gemmi's classes differ from ours, and why.
const std::set<std::string> kClassesDiffer = {
    // waters and ions of simulation packages (TIP3, SOL, SOD): ligands for gemmi
    "1tw7x2_h36.pdb.gz", "1tw7x2_hex.pdb.gz", "5digitresid.pdb", "5dfr_solvated.pdb.gz",
    "cryst_then_model.pdb", "lysozyme_md.pdb.gz", "triclinic.pdb", "xl_serial.pdb",
    // polymers without the atoms, elements or length by which gemmi recognises a polymer
    "adk_open.pdb.gz", "no_chain_name.pdb", "nucl_res.pdb", "difficult_quoting.cif", "1ssu_mod.cif",
    // ATOM records of unknown residues: ligands for us; polymer or nothing for gemmi
    "conect2ter.pdb", "singleconect.pdb", "random_walk.pdb",
    // an oxygen and two hydrogens without a residue name: water for us
    "short-atom.pdb", "short-cryst1.pdb",
    // a minimal table: one polymer with all waters for gemmi
    "2buk-assembly1.cif.gz"};

struct Counts {
  std::size_t atoms = 0, hydrogens = 0, hetero = 0;
  std::size_t waters = 0, polymers = 0, others = 0;
  std::vector<LatticePoint> positions;
};

Counts counts_of(const gemmi::Structure& structure, const Lattice& lattice) {
  Counts counts;
  const auto units = [&](double x) {
    return static_cast<std::int32_t>(std::lround(x * lattice.units_per_angstrom()));
  };
  for (const gemmi::Model& model : structure.models) {
    for (const gemmi::Chain& chain : model.chains) {
      for (const gemmi::Residue& residue : chain.residues) {
        for (const gemmi::Atom& atom : residue.atoms) {
          ++counts.atoms;
          counts.hydrogens += atom.is_hydrogen();
          counts.hetero += residue.het_flag == 'H';
          ++(residue.entity_type == gemmi::EntityType::Polymer ? counts.polymers
             : residue.entity_type == gemmi::EntityType::Water ? counts.waters
                                                               : counts.others);
          counts.positions.push_back({units(atom.pos.x), units(atom.pos.y), units(atom.pos.z)});
        }
      }
    }
  }
  std::sort(counts.positions.begin(), counts.positions.end());
  return counts;
}

Counts counts_of(const Molecule& molecule) {
  Counts counts;
  for (const Atom& atom : molecule.atoms) {
    ++counts.atoms;
    counts.hydrogens += atom.element == kHydrogen;
    counts.hetero += atom.hetero;
    ++(atom.kind == ResidueKind::polymer ? counts.polymers
       : atom.kind == ResidueKind::water ? counts.waters
                                         : counts.others);
    counts.positions.push_back(atom.position);
  }
  std::sort(counts.positions.begin(), counts.positions.end());
  return counts;
}

TEST(GemmiAgreement, EveryPdbAndMmcifFile) {
  ALPHASCOPE_NEED_TEST_DATA();
  std::size_t compared = 0;
  for (const DataRow& row : data_table()) {
    const std::filesystem::path path = test_data(row.file);
    const std::string name = path.filename().string();
    const bool structure_file = name.find(".pdb") != name.npos || name.find(".cif") != name.npos ||
                                name.find(".ent") != name.npos;
    if (!row.molecule || !structure_file || kGemmiDiffers.contains(name)) continue;
    if ((row.atoms + row.hetero) * row.models > kMostAtoms) continue;
    SCOPED_TRACE(path.string());
    gemmi::Structure theirs;
    try {
      theirs = gemmi::read_structure(gemmi::MaybeGzipped(path.string()));
      gemmi::setup_entities(theirs);
    } catch (const std::exception&) {
      continue;  // gemmi refuses it; the data folder's table has our result
    }
    Molecule ours;
    try {
      ours = read_molecule(path);
    } catch (const ReadError&) {
      for (const gemmi::Model& model : theirs.models) EXPECT_TRUE(model.chains.empty());
      continue;
    }
    const Counts a = counts_of(ours), b = counts_of(theirs, ours.lattice);
    if (b.atoms == 0) continue;  // gemmi reads nothing from minimal tables
    ++compared;
    EXPECT_EQ(a.atoms, b.atoms);
    EXPECT_EQ(a.hydrogens, b.hydrogens);
    EXPECT_EQ(a.hetero, b.hetero);
    EXPECT_TRUE(a.positions == b.positions);
    const bool same = a.polymers == b.polymers && a.waters == b.waters && a.others == b.others;
    EXPECT_NE(same, kClassesDiffer.contains(name))
        << "polymer, water, other: " << a.polymers << ' ' << a.waters << ' ' << a.others
        << "; gemmi " << b.polymers << ' ' << b.waters << ' ' << b.others;
  }
  EXPECT_GT(compared, 100u);
}

}  // namespace
}  // namespace alphascope
