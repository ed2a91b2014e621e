// SPDX-License-Identifier: GPL-3.0-or-later
// Completes the alpha complex from the simplices that are valid by themselves: adds their faces,
// alpha values and classes.
#pragma once

#include <array>
#include <vector>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

// Simplices whose own orthosphere is empty and whose ortho-radius is at most alpha. Each occurs
// once, in any order, with ascending vertices. Values are the floats nearest to the ortho-radius;
// there are none when only tetrahedra are requested.
template <int N>
struct UnattachedSimplices {
  Simplices<N> simplices;
  ResultArray<float> values;
};

struct UnattachedSimplicesByDimension {
  UnattachedSimplices<1> vertices;
  UnattachedSimplices<2> edges;
  UnattachedSimplices<3> triangles;
  UnattachedSimplices<4> tetrahedra;
};

// Fills the lists of `complex`, whose tetrahedra_only is an input. K_alpha is the closure of these
// simplices. A face that is not among them is attached, and has the least alpha value of its
// cofaces.
void complete_complex(UnattachedSimplicesByDimension own, std::size_t ball_count,
                      AlphaComplex& complex);

}  // namespace alphascope
