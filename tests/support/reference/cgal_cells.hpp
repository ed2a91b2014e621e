// SPDX-License-Identifier: GPL-3.0-or-later
// Code shared by the direct uses of CGAL's triangulation. Only sources that may include CGAL
// include it.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "tests/support/reference/cgal_reference.hpp"

namespace alphascope::testing::cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using WeightedPoint = Kernel::Weighted_point_3;
using PlainVertex = CGAL::Regular_triangulation_vertex_base_3<Kernel>;
using IndexedVertex = CGAL::Triangulation_vertex_base_with_info_3<BallIndex, Kernel, PlainVertex>;
using PlainCell = CGAL::Regular_triangulation_cell_base_3<Kernel>;

using Clock = std::chrono::steady_clock;
inline double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

inline std::vector<std::pair<WeightedPoint, BallIndex>> indexed_points(const BallSet& balls) {
  std::vector<std::pair<WeightedPoint, BallIndex>> points;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    points.emplace_back(
        WeightedPoint(Kernel::Point_3(p.x, p.y, p.z), static_cast<double>(balls.weight(i))), i);
  }
  return points;
}

// Inserts balls into an empty triangulation.
template <class Rt>
CgalCells cells_within(const BallSet& balls, Rt& rt, double alpha_on_lattice) {
  CgalCells result;
  const auto points = indexed_points(balls);
  Clock::time_point start = Clock::now();
  rt.insert(points.begin(), points.end());
  result.triangulation_milliseconds = milliseconds_since(start);
  start = Clock::now();
  const auto compare = rt.geom_traits().compare_weighted_squared_radius_3_object();
  for (auto c = rt.finite_cells_begin(); c != rt.finite_cells_end(); ++c) {
    if (compare(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                c->vertex(3)->point(), alpha_on_lattice) == CGAL::LARGER) {
      continue;
    }
    std::array<BallIndex, 4> tetrahedron;
    for (int n = 0; n < 4; ++n) tetrahedron[n] = c->vertex(n)->info();
    std::sort(tetrahedron.begin(), tetrahedron.end());
    result.tetrahedra.push_back(tetrahedron);
  }
  result.filter_milliseconds = milliseconds_since(start);
  return result;
}

template <class Concurrency>
using CellTriangulation = CGAL::Regular_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<IndexedVertex, PlainCell, Concurrency>>;

}  // namespace alphascope::testing::cgal
