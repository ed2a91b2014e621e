// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's own parallel triangulation. It is not in tests/support/reference/cgal_reference, which
// every engine test needs, because it takes equally long to compile.
#pragma once

#include "tests/support/reference/cgal_reference.hpp"

namespace alphascope::testing {

// Like regular_cells, with all threads.
CgalCells regular_cells_in_parallel(const BallSet& balls, double alpha_on_lattice);

}  // namespace alphascope::testing
