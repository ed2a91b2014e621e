// SPDX-License-Identifier: GPL-3.0-or-later
// All cavities of one K_alpha with their measures, in the order of a table.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/cavity/cavity_measures.hpp"

namespace alphascope {

class TriangulationMaker;

struct CavityParameters {
  Alpha alpha_angstrom2;
  double solvent_radius_angstrom = 0;  // already part of the radii of the ground's balls
  OutsideRule rule = OutsideRule::castp;
  bool split_networks = false;  // whether networks are listed as their parts
  friend bool operator==(const CavityParameters&, const CavityParameters&) = default;
};

struct CavityTable {
  std::shared_ptr<const CavityGround> ground;
  CavityParameters question;
  Cavities found;
  std::vector<CavityMeasures> measures;  // one for each of found.cavities
  // Indices of found.cavities by falling SA volume. Row 0 is CASTp's cavity 1.
  std::vector<std::uint32_t> order;

  std::size_t voids = 0, pockets = 0, mouths = 0;  // parts of networks count as pockets

  const Cavity& cavity(std::size_t row) const { return found.cavities[order[row]]; }
  const CavityMeasures& measure(std::size_t row) const { return measures[order[row]]; }
  std::size_t size() const { return order.size(); }
  // The balls of the deepest sink, ascending. They identify the cavity.
  const std::array<BallIndex, 4>& sink(std::size_t row) const;
  // Sums over all voids, or over all pockets.
  double volume_sa_angstrom3(bool of_voids) const;
  double area_sa_angstrom2(bool of_voids) const;
};

// The exact volume and area of every cavity, in the order of found.cavities. They take longer than
// the table and can be computed after it. Only pockets are clipped. No ball pokes out of a void, so
// the sums of voids are exact already.
std::vector<ExactCavityMeasures> measure_all_exactly(const CavityTable& table,
                                                     const RunContext& context = {});

// Returns whether the exact volume is below 1 Å³, or the SA volume is off by more than a tenth. The
// user must then see the difference.
bool differs_from_exact(double sa_angstrom3, double exact_angstrom3);

// Makes the table for the balls of the ground. Works in the caller's task arena; the result does
// not depend on the number of threads. `maker`: whose device helps, if there is one. Throws
// Cancelled, and std::invalid_argument if alpha is NaN.
CavityTable make_cavity_table(std::shared_ptr<const CavityGround> ground,
                              const CavityParameters& question, const RunContext& context = {},
                              TriangulationMaker* maker = nullptr);

}  // namespace alphascope
