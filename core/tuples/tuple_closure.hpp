// From the simplices that are valid by themselves to the alpha complex: their faces, alpha values
// and classes. Where the simplices come from is the engines' business.
#pragma once

#include <array>
#include <vector>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

// Simplices whose own orthosphere is empty and whose ortho-radius is at most alpha, each once, in
// any order; vertices of each ascend. Values (nearest float of the ortho-radius) are empty when
// only tetrahedra are asked for.
template <int N>
struct OwnSimplices {
  Simplices<N> simplices;
  ResultArray<float> values;
};

struct OwnSimplicesByDimension {
  OwnSimplices<1> vertices;
  OwnSimplices<2> edges;
  OwnSimplices<3> triangles;
  OwnSimplices<4> tetrahedra;
};

// Fills the lists of `complex` (tetrahedra_only is read from it): K_alpha is the closure of these
// simplices. A face that is not among them is attached, and has the least value of its cofaces.
void complete_complex(OwnSimplicesByDimension own, std::size_t ball_count, AlphaComplex& complex);

}  // namespace alphascope
