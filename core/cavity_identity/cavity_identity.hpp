// SPDX-License-Identifier: GPL-3.0-or-later
// Matches the cavities of two tables of the same atoms.
//
// In one triangulation, at two alphas, a cavity is identified by its deepest sink. With another
// solvent radius or other positions of the atoms the triangulations differ. Then the volume that
// two cavities share decides. It is that of the later cavity's tetrahedra whose centroids lie in
// the earlier one. A tetrahedron of the same four balls in both counts as a whole. Volumes are
// whole numbers on the lattice, so no rounding decides.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cavity_identity/cavity_match.hpp"
#include "core/complex/simplices.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;
struct CavityMatch;
struct CavityTable;

// Both tables must be of balls with the same indices. Works in the caller's task arena; the result
// does not depend on the number of threads. Throws Cancelled, and std::invalid_argument if the
// numbers of balls differ.
CavityMatch match_cavities(const CavityTable& earlier, const CavityTable& later,
                           const CancelToken& cancel = {});

// The part of a table that a later match needs, without its triangulation.
struct CavityRegions {
  Simplices<4> tetrahedra;                      // all cavities' tetrahedra, in lexicographic order
  std::vector<std::uint32_t> cavity;            // for each tetrahedron
  std::vector<std::array<BallIndex, 4>> sinks;  // for each cavity its deepest sink
};
CavityRegions regions_of(const CavityTable& table);

// Matches by tetrahedra of the same four balls alone. `balls` are at the later positions.
CavityMatch match_regions(const CavityRegions& earlier, const CavityRegions& later,
                          const BallSet& balls);

}  // namespace alphascope
