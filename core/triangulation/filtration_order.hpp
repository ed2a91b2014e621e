// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a growing alpha reaches the simplices of a complex.
#pragma once

#include <cstdint>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct AlphaComplex;
struct BallSet;

// A simplex of a complex: one of its list of this dimension.
struct SimplexPlace {
  std::uint32_t dimension, index;
  friend bool operator==(const SimplexPlace&, const SimplexPlace&) = default;
};

// All simplices of a whole complex of these balls: by their exact alpha values, then by dimension,
// then in lexicographic order. Where alpha values round to the same float, integers decide. So each
// K_alpha below is a beginning of the order, and a face comes before its cofaces. Works in the
// caller's task arena. Throws Cancelled, and std::invalid_argument for a complex of tetrahedra
// only.
std::vector<SimplexPlace> filtration_order(const BallSet& balls, const AlphaComplex& complex,
                                           const CancelToken& cancel = {});

}  // namespace alphascope
