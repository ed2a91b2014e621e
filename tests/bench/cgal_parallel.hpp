// CGAL's own parallel triangulation. Every engine test needs
// tests/support/reference/cgal_reference. This one is separate, because it takes as long to
// compile.
#pragma once

#include "tests/support/reference/cgal_reference.hpp"

namespace alphascope::testing {

// Like regular_cells, with all threads.
CgalCells regular_cells_in_parallel(const BallSet& balls, double alpha_on_lattice);

}  // namespace alphascope::testing
