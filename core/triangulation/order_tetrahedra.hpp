// SPDX-License-Identifier: GPL-3.0-or-later
// Puts tetrahedra, given in any order, into the one order of a Triangulation.
#pragma once

#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

struct UnorderedTetrahedra {
  static constexpr std::uint32_t kOutside = ~std::uint32_t{0};

  Simplices<4> tetrahedra;  // the balls of each are in ascending order
  // [t][k]: index of the tetrahedron across the face opposite ball k of t, or kOutside.
  ResultArray<std::array<std::uint32_t, 4>> neighbours;
};

// Fills tetrahedra, neighbours and hull of `result`. Works in the caller's task arena. Throws
// Cancelled, and std::length_error for more tetrahedra than a Neighbour can name.
void set_tetrahedra(const BallSet& balls, const UnorderedTetrahedra& unordered,
                    const CancelToken& cancel, Triangulation& result);

// A face without a neighbour, opposite a corner of a tetrahedron.
struct OutsideFace {
  std::uint32_t tetrahedron;
  int corner;
  std::array<BallIndex, 4> balls;  // of the tetrahedron
};

// Makes the facets of the hull, in their order, into which it puts `outside`, too. The tetrahedra
// are in order.
std::vector<HullFacet> hull_facets(const BallSet& balls, std::vector<OutsideFace>& outside);

// Sets those facets as the neighbours that are still missing.
void set_hull(std::vector<HullFacet> facets, const std::vector<OutsideFace>& outside,
              Triangulation& result);

}  // namespace alphascope
