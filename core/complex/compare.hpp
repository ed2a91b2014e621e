// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of two complexes as sets of simplices.
#pragma once

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

template <int N>
struct SetDifference {
  std::size_t common = 0;
  std::vector<std::array<BallIndex, N>> missing;  // in the reference only
  std::vector<std::array<BallIndex, N>> extra;    // in the candidate only
  bool equal() const { return missing.empty() && extra.empty(); }
};

struct Comparison {
  // True if either side has only tetrahedra; other simplices are then not compared.
  bool tetrahedra_only = false;
  // Both complexes came from CGAL's triangulation, so it proves nothing that they are equal.
  bool both_rest_on_cgal = false;
  SetDifference<1> vertices;
  SetDifference<2> edges;
  SetDifference<3> triangles;
  SetDifference<4> tetrahedra;
  // Number of common simplices whose alpha values or classes differ (only for whole complexes;
  // expected 0).
  std::size_t alpha_values_differing = 0;
  std::size_t classes_differing = 0;

  bool identical() const {
    return vertices.equal() && edges.equal() && triangles.equal() && tetrahedra.equal() &&
           alpha_values_differing == 0 && classes_differing == 0;
  }
};

Comparison compare(const AlphaComplex& candidate, const AlphaComplex& reference);

}  // namespace alphascope
