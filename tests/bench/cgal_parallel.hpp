// CGAL's own parallel triangulation. Apart from tests/support/reference/cgal_reference, which every
// test of an engine needs: it takes as long to compile.
#pragma once

#include "tests/support/reference/cgal_reference.hpp"

namespace alphascope::testing {

// As regular_cells, with all threads.
CgalCells regular_cells_in_parallel(const BallSet& balls, double alpha_on_lattice);

}  // namespace alphascope::testing
