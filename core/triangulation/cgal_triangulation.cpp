// The only source of the core that includes CGAL. The lattice integers are passed to it as doubles,
// which is exact; its kernel filters and then decides exactly.
#include "core/triangulation/cgal_triangulation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/neighbours/coincident.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using WeightedPoint = Kernel::Weighted_point_3;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<BallIndex, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;

// CGAL keeps hidden points in its cells for later removals of vertices, which never happen here.
struct NoPoints {
  using iterator = WeightedPoint*;
  using const_iterator = const WeightedPoint*;
  iterator begin() { return nullptr; }
  iterator end() { return nullptr; }
  const_iterator begin() const { return nullptr; }
  const_iterator end() const { return nullptr; }
};
using CellBase =
    CGAL::Regular_triangulation_cell_base_3<Kernel, CGAL::Triangulation_cell_base_3<Kernel>,
                                            CGAL::Discard_hidden_points, NoPoints>;

template <class Concurrency>
using Triangulation = CGAL::Regular_triangulation_3<
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

// Spatial sorting, then one point after the other from the cell of the last one: what CGAL's own
// range insertion does, with a look at the cancel token in between.
void insert_all(Triangulation<CGAL::Sequential_tag>& rt, std::vector<InputPoint>& points,
                const RunContext& context) {
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, CentreOf>;
  CGAL::spatial_sort(points.begin(), points.end(), Traits(CentreOf()));
  Triangulation<CGAL::Sequential_tag>::Cell_handle hint;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (n % 2048 == 0) {
      context.cancel.throw_if_cancelled();
      context.report(stage::kTriangulation,
                     static_cast<double>(n) / static_cast<double>(points.size()));
    }
    Triangulation<CGAL::Sequential_tag>::Locate_type type;
    int i, j;
    const auto cell = rt.locate(points[n].first, type, i, j, hint);
    const auto vertex = rt.insert(points[n].first, type, cell, i, j);
    if (vertex != nullptr) vertex->info() = points[n].second;
    hint = vertex == nullptr ? cell : vertex->cell();
  }
}

// CGAL's parallel range insertion cannot be interrupted, so it gets one chunk after another. The
// sort's coarse levels come first, hence every chunk but the last ones spreads over all space.
void insert_all(Triangulation<CGAL::Parallel_tag>& rt, std::vector<InputPoint>& points,
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

template <class Rt>
RegularTriangulation copy_out(const Rt& rt, std::size_t ball_count) {
  RegularTriangulation out;
  out.dimension = rt.dimension();
  if (out.dimension == 3) {
    out.tetrahedra.reserve(rt.tds().number_of_cells());
    for (auto c = rt.finite_cells_begin(); c != rt.finite_cells_end(); ++c) {
      out.tetrahedra.push_back(ascending_vertices<4>(c));
    }
  } else if (out.dimension == 2) {
    for (auto f = rt.finite_facets_begin(); f != rt.finite_facets_end(); ++f) {
      out.triangles.push_back(ascending_vertices<3>(f->first));
    }
  } else if (out.dimension == 1) {
    for (auto e = rt.finite_edges_begin(); e != rt.finite_edges_end(); ++e) {
      out.edges.push_back(ascending_vertices<2>(e->first));
    }
  }
  std::vector<bool> visible(ball_count, false);
  for (auto v = rt.finite_vertices_begin(); v != rt.finite_vertices_end(); ++v) {
    visible[v->info()] = true;
  }
  out.vertices.reserve(rt.number_of_vertices());
  for (BallIndex i = 0; i < ball_count; ++i) {
    (visible[i] ? out.vertices : out.hidden).push_back(i);
  }
  return out;
}

RegularTriangulation triangulate_parallel(std::vector<InputPoint>& points, std::size_t ball_count,
                                          const RunContext& context) {
  // 30, 50 and 100 cells per axis measured alike up to 217k balls.
  constexpr int kLockCellsPerAxis = 50;
  CGAL::Bbox_3 box;
  for (const InputPoint& p : points) box += p.first.bbox();
  Triangulation<CGAL::Parallel_tag>::Lock_data_structure locks(box, kLockCellsPerAxis);
  Triangulation<CGAL::Parallel_tag> rt(&locks);
  insert_all(rt, points, context);
  context.cancel.throw_if_cancelled();
  return copy_out(rt, ball_count);
}

}  // namespace

RegularTriangulation triangulate(const BallSet& balls, int threads, const RunContext& context) {
  std::vector<InputPoint> points = visible_input(balls);
  // CGAL's locks make its parallel code 1.4 times as slow on one thread, and its spinning makes it
  // lose on two as soon as anything else runs on the machine; its first 100 points are sequential.
  constexpr std::size_t kWorthBalls = 4096;
  constexpr int kWorthThreads = 3;
  if (threads >= kWorthThreads && points.size() >= kWorthBalls) {
    return triangulate_parallel(points, balls.size(), context);
  }
  Triangulation<CGAL::Sequential_tag> rt;
  insert_all(rt, points, context);
  context.cancel.throw_if_cancelled();
  return copy_out(rt, balls.size());
}

}  // namespace alphascope
