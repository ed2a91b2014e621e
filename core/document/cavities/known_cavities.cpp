// SPDX-License-Identifier: GPL-3.0-or-later
// Computes facts on a cavity from the results that KnownCavities holds.
#include "core/document/cavities/known_cavities.hpp"

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {

std::size_t KnownCavities::size() const {
  return all ? all->size() : 0;
}

const ExactCavityMeasures& KnownCavities::exact_measures(std::size_t row) const {
  return exact->of[table().order[row]];
}

std::string KnownCavities::name(std::size_t row) const {
  return cavity_name(*atoms, table(), row);
}

bool KnownCavities::differs_from_exact(std::size_t row) const {
  return alphascope::differs_from_exact(table().measure(row).volume_sa_angstrom3,
                                        exact_measures(row).volume_sa_angstrom3);
}

const char* KnownCavities::kind(std::size_t row) const {
  const Cavity& cavity = table().cavity(row);
  return cavity.is_void() ? "void" : cavity.is_part() ? "part" : "pocket";
}

std::size_t KnownCavities::lining_residues(std::size_t row) const {
  return lines ? lines->of[row].lining.residues : lining_counts(*atoms, table(), row).residues;
}

std::string KnownCavities::contents_text(std::size_t row) const {
  return alphascope::contents_text(atoms->molecule(), *contents, table().order[row]);
}

KnownCavities::Life KnownCavities::life(std::size_t row) const {
  const CavityLife& life = lives->of(table().cavity(row).deepest_sink);
  const Lattice& lattice = table().ground->balls->lattice;
  return {lattice.square_angstrom(life.born), lattice.square_angstrom(life.closed),
          lattice.square_angstrom(life.gone), life.closed < life.gone};
}

}  // namespace alphascope
