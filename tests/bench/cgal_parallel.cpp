// SPDX-License-Identifier: GPL-3.0-or-later
// Runs CGAL's own parallel triangulation.
#include "tests/bench/cgal_parallel.hpp"

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "tests/support/reference/cgal_cells.hpp"

namespace alphascope::testing {

CgalCells regular_cells_in_parallel(const BallSet& balls, double alpha_on_lattice) {
  CGAL::Bbox_3 box;
  for (const LatticePoint& p : balls.centres) box += CGAL::Bbox_3(p.x, p.y, p.z, p.x, p.y, p.z);
  using Triangulation = cgal::CellTriangulation<CGAL::Parallel_tag>;
  Triangulation::Lock_data_structure locks(box, 50);
  Triangulation triangulation(&locks);
  return cgal::cells_within(balls, triangulation, alpha_on_lattice);
}

}  // namespace alphascope::testing
