// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation by CGAL, and its copy into our own arrays. This is the only source of the core
// that includes CGAL. CGAL gets the lattice integers as doubles, which is exact. Its kernel filters
// and then decides exactly.
#include "core/triangulation/cgal_triangulation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/insertion/order_tetrahedra.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using WeightedPoint = Kernel::Weighted_point_3;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<BallIndex, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;

// CGAL keeps hidden points in its cells for a later removal of vertices. This program removes none,
// so this container stays empty.
struct NoPoints {
  using iterator = WeightedPoint*;
  using const_iterator = const WeightedPoint*;
  iterator begin() { return nullptr; }
  iterator end() { return nullptr; }
  const_iterator begin() const { return nullptr; }
  const_iterator end() const { return nullptr; }
};
// A cell with its number among the finite cells.
using NumberedCell = CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel>;
using CellBase = CGAL::Regular_triangulation_cell_base_3<Kernel, NumberedCell,
                                                         CGAL::Discard_hidden_points, NoPoints>;

template <class Concurrency>
using CgalTriangulation = CGAL::Regular_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase, Concurrency>>;

using InputPoint = std::pair<WeightedPoint, BallIndex>;

// The key by which spatial_sort orders the input.
struct CentreOf {
  using key_type = InputPoint;
  using value_type = Kernel::Point_3;
  using reference = const Kernel::Point_3&;
  using category = boost::readable_property_map_tag;
  friend reference get(const CentreOf&, const InputPoint& input) { return input.first.point(); }
};

std::vector<InputPoint> visible_input(const BallSet& balls) {
  const std::vector<bool> hidden = coincident_hidden(balls);
  std::vector<InputPoint> points;
  points.reserve(balls.size());
  for (BallIndex i = 0; i < balls.size(); ++i) {
    if (!hidden.empty() && hidden[i]) continue;
    const LatticePoint& p = balls.centres[i];
    points.emplace_back(
        WeightedPoint(Kernel::Point_3(p.x, p.y, p.z), static_cast<double>(balls.weight(i))), i);
  }
  return points;
}

// Inserts the points in spatial order, each from the cell of the one before. CGAL's own range
// insertion does the same; here the cancel token is read in between.
void insert_all(CgalTriangulation<CGAL::Sequential_tag>& rt, std::vector<InputPoint>& points,
                const RunContext& context) {
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, CentreOf>;
  CGAL::spatial_sort(points.begin(), points.end(), Traits(CentreOf()));
  CgalTriangulation<CGAL::Sequential_tag>::Cell_handle hint;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (n % 2048 == 0) {
      context.cancel.throw_if_cancelled();
      context.report(stage::kTriangulation,
                     static_cast<double>(n) / static_cast<double>(points.size()));
    }
    CgalTriangulation<CGAL::Sequential_tag>::Locate_type type;
    int i, j;
    const auto cell = rt.locate(points[n].first, type, i, j, hint);
    const auto vertex = rt.insert(points[n].first, type, cell, i, j);
    if (vertex != nullptr) vertex->info() = points[n].second;
    hint = vertex == nullptr ? cell : vertex->cell();
  }
}

// CGAL's parallel range insertion cannot be interrupted, so it gets the points in chunks, and the
// token is read between them. The sort puts a coarse sample of the points first, then finer ones.
// So every chunk but the last ones spreads over all space.
void insert_all(CgalTriangulation<CGAL::Parallel_tag>& rt, std::vector<InputPoint>& points,
                const RunContext& context) {
  constexpr std::size_t kChunk = 131072;
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, CentreOf>;
  if (points.size() > kChunk) {
    CGAL::spatial_sort<CGAL::Parallel_tag>(points.begin(), points.end(), Traits(CentreOf()));
  }
  for (std::size_t begin = 0; begin < points.size(); begin += kChunk) {
    context.cancel.throw_if_cancelled();
    context.report(stage::kTriangulation,
                   static_cast<double>(begin) / static_cast<double>(points.size()));
    const std::size_t end = std::min(begin + kChunk, points.size());
    rt.insert(points.begin() + static_cast<std::ptrdiff_t>(begin),
              points.begin() + static_cast<std::ptrdiff_t>(end));
  }
}

template <std::size_t N, class Cell>
std::array<BallIndex, N> ascending_vertices(const Cell& cell) {
  std::array<BallIndex, N> simplex;
  for (std::size_t n = 0; n < N; ++n) simplex[n] = cell->vertex(static_cast<int>(n))->info();
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

// Numbers the cells in CGAL's order, then reads the numbers of each cell's neighbours.
template <class Rt>
UnorderedTetrahedra copy_tetrahedra(Rt& rt, const CancelToken& cancel) {
  std::vector<typename Rt::Cell_handle> cells;
  cells.reserve(rt.tds().number_of_cells());
  for (auto c = rt.all_cells_begin(); c != rt.all_cells_end(); ++c) {
    const bool finite = !rt.is_infinite(c);
    c->info() = finite ? static_cast<std::uint32_t>(cells.size()) : TetrahedronCorner::kOutside;
    if (finite) cells.push_back(c);
  }
  cancel.throw_if_cancelled();
  UnorderedTetrahedra result;
  result.tetrahedra.resize(cells.size());
  parallel_each(0, cells.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k) {
      result.tetrahedra[t][static_cast<std::size_t>(k)] = {cells[t]->vertex(k)->info(),
                                                           cells[t]->neighbor(k)->info()};
    }
  });
  return result;
}

// Copies all that is also there below dimension 3: vertices and hidden balls, and the simplices of
// a triangulation of dimension 1 or 2.
template <class Rt>
Triangulation copy_flat(const Rt& rt, std::size_t ball_count) {
  Triangulation out;
  out.dimension = rt.dimension();
  if (out.dimension == 2) {
    for (auto f = rt.finite_facets_begin(); f != rt.finite_facets_end(); ++f) {
      out.triangles.push_back(ascending_vertices<3>(f->first));
    }
    std::sort(out.triangles.begin(), out.triangles.end());
  } else if (out.dimension == 1) {
    for (auto e = rt.finite_edges_begin(); e != rt.finite_edges_end(); ++e) {
      out.edges.push_back(ascending_vertices<2>(e->first));
    }
    std::sort(out.edges.begin(), out.edges.end());
  }
  std::vector<bool> visible(ball_count, false);
  for (auto v = rt.finite_vertices_begin(); v != rt.finite_vertices_end(); ++v) {
    visible[v->info()] = true;
  }
  out.vertices.reserve(rt.number_of_vertices());
  out.hidden.reserve(ball_count - rt.number_of_vertices());
  for (BallIndex i = 0; i < ball_count; ++i) {
    (visible[i] ? out.vertices : out.hidden).push_back(i);
  }
  return out;
}

// Frees CGAL's triangulation, which is larger than its copy, before the copy is put in order.
template <class Rt>
Triangulation finish(const BallSet& balls, std::unique_ptr<Rt> rt, const RunContext& context) {
  context.cancel.throw_if_cancelled();
  Triangulation result = copy_flat(*rt, balls.size());
  if (result.dimension < 3) return result;
  const UnorderedTetrahedra tetrahedra = copy_tetrahedra(*rt, context.cancel);
  rt.reset();
  set_tetrahedra(balls, tetrahedra, context.cancel, result);
  return result;
}

Triangulation triangulate_parallel(const BallSet& balls, std::vector<InputPoint>& points,
                                   const RunContext& context) {
  // 30, 50 and 100 cells per axis took equal time for up to 217,000 balls.
  constexpr int kLockCellsPerAxis = 50;
  using Rt = CgalTriangulation<CGAL::Parallel_tag>;
  CGAL::Bbox_3 box;
  for (const InputPoint& p : points) box += p.first.bbox();
  Rt::Lock_data_structure locks(box, kLockCellsPerAxis);
  auto rt = std::make_unique<Rt>(&locks);
  insert_all(*rt, points, context);
  return finish(balls, std::move(rt), context);
}

}  // namespace

Triangulation make_cgal_triangulation(const BallSet& balls, int threads,
                                      const RunContext& context) {
  require_balls(balls.size());
  std::vector<InputPoint> points = visible_input(balls);
  // On one thread CGAL's parallel code takes 1.4 times as long as its sequential code, because of
  // its locks. On two threads its waiting loops make it slower as soon as other programs run. With
  // few points it does not pay: it inserts the first 100 one after another.
  constexpr std::size_t kWorthBalls = 4096;
  constexpr int kWorthThreads = 3;
  if (threads >= kWorthThreads && points.size() >= kWorthBalls) {
    return triangulate_parallel(balls, points, context);
  }
  auto rt = std::make_unique<CgalTriangulation<CGAL::Sequential_tag>>();
  insert_all(*rt, points, context);
  return finish(balls, std::move(rt), context);
}

}  // namespace alphascope
