// SPDX-License-Identifier: GPL-3.0-or-later
// Ties: the simplices of a filtration whose alpha value and alpha itself round to the same float.
// Only for these the float does not tell whether they are in K_alpha.
#pragma once

#include <algorithm>
#include <vector>

#include "core/triangulation/filtration.hpp"

namespace alphascope {

// The ties of one dimension.
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

// Decides all ties by exact predicates. The other dimensions are left empty with tetrahedra_only.
AllTies decide_ties(const Filtration& filtration, const LatticeAlpha& alpha_on_lattice,
                    bool tetrahedra_only);

}  // namespace alphascope
