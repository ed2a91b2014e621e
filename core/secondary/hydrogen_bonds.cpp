// SPDX-License-Identifier: GPL-3.0-or-later
// Places hydrogens on nitrogens, and computes energies of pairs of residues.
#include "core/secondary/hydrogen_bonds.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// The energy of charges q1 = 0.42 e at C and O and q2 = 0.20 e at N and H, with the factor
// 332 Å kcal/mol of the paper: 27.888 Å kcal/mol.
constexpr double kCoupling = 332 * 0.42 * 0.20;
constexpr double kWeakest = -0.5;  // kcal/mol: a bond is below it
constexpr double kLowest = -9.9;   // kcal/mol: of atoms nearer than kNearest, and of any bond
constexpr double kNearest = 0.5;   // Å
// Å. Residues whose CA are further apart are not bonded.
constexpr double kReach = 9.0;
// Candidates that are tried for a residue. In proteins there are some 40 CA within 9 Å.
constexpr std::size_t kMostTried = 2048;

struct Group {  // Å
  RealPoint n, h, ca, c, o;
  bool gives = false;  // has a hydrogen at N
};

std::vector<Group> place_groups(const Molecule& molecule,
                                const std::vector<BackboneResidue>& residues) {
  std::vector<Group> groups;
  groups.reserve(residues.size());
  for (std::size_t k = 0; k < residues.size(); ++k) {
    const BackboneResidue& residue = residues[k];
    Group group{position_angstrom(molecule, residue.n),  {},
                position_angstrom(molecule, residue.ca), position_angstrom(molecule, residue.c),
                position_angstrom(molecule, residue.o),  !residue.ring_at_nitrogen};
    // H is 1 Å from N, in the direction from O to C of the residue before. Without such a residue
    // DSSP leaves it at N, where N-H has no dipole.
    group.h = group.n;
    if (k > 0 && residues[k - 1].bound_to_next) {
      group.h = group.n + unit_vector(groups[k - 1].c - groups[k - 1].o);
    }
    groups.push_back(group);
  }
  return groups;
}

// kcal/mol, in thousandths as DSSP rounds it.
double bond_energy(const Group& donor, const Group& acceptor) {
  if (!donor.gives) return 0;
  const double ho = length(donor.h - acceptor.o), hc = length(donor.h - acceptor.c),
               nc = length(donor.n - acceptor.c), no = length(donor.n - acceptor.o);
  if (std::min({ho, hc, nc, no}) < kNearest) return kLowest;
  const double energy = kCoupling * (1 / no + 1 / hc - 1 / ho - 1 / nc);
  return std::max(std::round(energy * 1000) / 1000, kLowest);
}

void note(HydrogenBonds& bonds, std::uint32_t acceptor, double energy) {
  auto& energies = bonds.energy_kilocalories_per_mole;
  if (energy < energies[0]) {
    energies[1] = energies[0];
    bonds.acceptor[1] = bonds.acceptor[0];
    energies[0] = energy;
    bonds.acceptor[0] = acceptor;
  } else if (energy < energies[1]) {
    energies[1] = energy;
    bonds.acceptor[1] = acceptor;
  }
}

// Balls at the CA whose radius is half the reach: only residues in reach meet.
UniformGrid grid_of(const Molecule& molecule, const std::vector<BackboneResidue>& residues) {
  BallSet balls;
  balls.lattice = molecule.lattice;
  const auto radius =
      static_cast<std::int32_t>(std::ceil(kReach / 2 * molecule.lattice.units_per_angstrom()));
  for (const BackboneResidue& residue : residues) {
    balls.centres.push_back(molecule.atoms[residue.ca].position);
  }
  balls.radii.assign(balls.centres.size(), radius);
  return make_uniform_grid(balls, LatticeAlpha(0), {});
}

}  // namespace

HydrogenBondList find_hydrogen_bonds(const Molecule& molecule,
                                     const std::vector<BackboneResidue>& residues,
                                     const RunContext& context) {
  const std::vector<Group> groups = place_groups(molecule, residues);
  const UniformGrid grid = grid_of(molecule, residues);
  HydrogenBondList list;
  list.of_donor.resize(groups.size());
  std::vector<std::uint8_t> crowded(groups.size(), 0);
  parallel_many(groups.size(), context.cancel, [&](std::size_t donor) {
    // Acceptors come in ascending order, so that equal energies have one result.
    std::vector<std::uint32_t> near;
    std::size_t tried = 0;
    const LatticePoint& place = molecule.atoms[residues[donor].ca].position;
    grid.for_rows_around(grid.cell_at(place), [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t slot = begin; slot < end && tried < kMostTried; ++slot, ++tried) {
        const std::uint32_t other = grid.ball[slot];
        // The C=O of the residue before is bound to this very N.
        if (other == donor || other + 1 == donor) continue;
        if (length(groups[other].ca - groups[donor].ca) < kReach) near.push_back(other);
      }
    });
    crowded[donor] = tried >= kMostTried;
    std::sort(near.begin(), near.end());
    for (const std::uint32_t acceptor : near) {
      note(list.of_donor[donor], acceptor, bond_energy(groups[donor], groups[acceptor]));
    }
    HydrogenBonds& bonds = list.of_donor[donor];
    for (std::size_t k = 0; k < 2; ++k) {
      if (bonds.energy_kilocalories_per_mole[k] < kWeakest) continue;
      bonds.acceptor[k] = HydrogenBonds::kNone;
      bonds.energy_kilocalories_per_mole[k] = 0;
    }
  });
  list.crowded = static_cast<std::size_t>(std::count(crowded.begin(), crowded.end(), 1));
  return list;
}

}  // namespace alphascope
