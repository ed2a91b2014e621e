// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL used directly, as its manual shows, without code of the program. Tests and benchmarks
// compare our CGAL engine with it.
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope::testing {

// Simplices and classes of Fixed_alpha_shape_3; alpha values are 0. Its triangulation must have
// dimension 3 (else std::invalid_argument). Balls must have distinct centres.
struct CgalReference {
  AlphaComplex complex;
  double triangulation_milliseconds = 0, classification_milliseconds = 0;
};
CgalReference fixed_alpha_shape(const BallSet& balls, double alpha_on_lattice);

// The cells of ortho-radius <= alpha, after one range insertion into the regular triangulation.
// Cells are in no particular order; the vertices of each ascend.
struct CgalCells {
  Simplices<4> tetrahedra;
  double triangulation_milliseconds = 0, filter_milliseconds = 0;
};
CgalCells regular_cells(const BallSet& balls, double alpha_on_lattice);

}  // namespace alphascope::testing
