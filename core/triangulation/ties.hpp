// The simplices of a filtration whose alpha value rounds to the very float that alpha rounds to:
// there, and only there, the float does not say whether they are in K_alpha.
#pragma once

#include <algorithm>
#include <vector>

#include "core/triangulation/filtration.hpp"

namespace alphascope {

// Of one dimension.
template <int N>
struct Ties {
  Simplices<N> simplices;  // in lexicographic order
  std::vector<char> in_complex;

  bool any(bool in) const { return std::count(in_complex.begin(), in_complex.end(), in) > 0; }
};

struct AllTies {
  Ties<1> vertices;
  Ties<2> edges;
  Ties<3> triangles;
  Ties<4> tetrahedra;

  bool any(bool in) const {
    return vertices.any(in) || edges.any(in) || triangles.any(in) || tetrahedra.any(in);
  }
};

// Decided in integers. Of tetrahedra_only, the other dimensions are left empty.
AllTies decide_ties(const Filtration& filtration, const LatticeAlpha& alpha_on_lattice,
                    bool tetrahedra_only);

}  // namespace alphascope
