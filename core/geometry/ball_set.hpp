// SPDX-License-Identifier: GPL-3.0-or-later
// The input of every engine: balls on the lattice. Later steps know no files or elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_index.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {

struct BallSet {
  Lattice lattice;
  std::vector<LatticePoint> centres;  // lattice units
  std::vector<std::int32_t> radii;    // lattice units, 0 < radius <= kMaxLatticeRadius

  std::size_t size() const { return centres.size(); }
  // Weight r² of power distance, in square lattice units (below 2^52: exact as a double).
  std::int64_t weight(BallIndex i) const { return std::int64_t{radii[i]} * radii[i]; }
  friend bool operator==(const BallSet&, const BallSet&) = default;
};

// The digits of the finest lattice, up to `wanted`, that holds these balls when their radii grow by
// `growth_angstrom`. Never fewer than the balls have now.
int finest_digits(const BallSet& balls, int wanted, double growth_angstrom);

// The same balls in units of 10^-digits Å. `digits` must be at least what they have, and within the
// bounds.
BallSet on_finer_lattice(const BallSet& balls, int digits);

// The same balls with every radius grown by the solvent radius (Å, >= 0), on a finer lattice if the
// solvent radius needs one. If the bounds allow none that is fine enough, the solvent radius is
// rounded to `solvent_on_lattice` of the result's lattice. Throws std::invalid_argument when a
// grown radius exceeds the lattice's bounds.
BallSet with_solvent(const BallSet& balls, double solvent_radius_angstrom);
inline double solvent_on_lattice(const Lattice& lattice, double solvent_radius_angstrom) {
  return lattice.angstrom(lattice.nearest_units(solvent_radius_angstrom));
}

}  // namespace alphascope
