// CGAL used directly, as its manual shows, without anything of the program: the peer of its own
// CGAL engine in tests and benchmarks.
#pragma once

#include "core/complex/alpha_complex.hpp"

namespace alphascope::testing {

// The simplices and classes that Fixed_alpha_shape_3 finds; alpha values are 0. Its triangulation
// must have dimension 3 (else std::invalid_argument); balls must have distinct centres.
struct CgalReference {
  AlphaComplex complex;
  double triangulation_milliseconds = 0, classification_milliseconds = 0;
};
CgalReference fixed_alpha_shape(const BallSet& balls, double alpha_on_lattice);

// The regular triangulation by one range insertion, then the cells of ortho-radius <= alpha.
// In no particular order; vertices of each ascend.
struct CgalCells {
  Simplices<4> tetrahedra;
  double triangulation_milliseconds = 0, filter_milliseconds = 0;
};
CgalCells regular_cells(const BallSet& balls, double alpha_on_lattice);

}  // namespace alphascope::testing
