// SPDX-License-Identifier: GPL-3.0-or-later
// Computes alpha shapes with CGAL alone.
#include "tests/support/reference/cgal_reference.hpp"

#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>

#include <algorithm>
#include <stdexcept>

#include "core/geometry/ball_set.hpp"
#include "tests/support/reference/cgal_cells.hpp"

namespace alphascope::testing {
namespace {

using namespace cgal;

template <class Shape, class Kind>
SimplexClass simplex_class(Kind kind) {
  return kind == Shape::SINGULAR  ? SimplexClass::singular
         : kind == Shape::REGULAR ? SimplexClass::regular
                                  : SimplexClass::interior;
}

template <int N>
struct Entry {
  std::array<BallIndex, N> simplex;
  SimplexClass simplex_class;
};

template <int N>
void store(std::vector<Entry<N>> entries, SimplexList<N>& list) {
  for (Entry<N>& e : entries) std::sort(e.simplex.begin(), e.simplex.end());
  std::sort(entries.begin(), entries.end(),
            [](const Entry<N>& a, const Entry<N>& b) { return a.simplex < b.simplex; });
  for (const Entry<N>& e : entries) {
    list.simplices.push_back(e.simplex);
    list.classes.push_back(e.simplex_class);
  }
  list.alpha_values.assign(list.size(), 0.0f);
}

template <class Shape>
void copy_out(const Shape& shape, AlphaComplex& complex) {
  std::vector<Entry<1>> vertices;
  std::vector<Entry<2>> edges;
  std::vector<Entry<3>> triangles;
  std::vector<Entry<4>> tetrahedra;
  for (auto v = shape.finite_vertices_begin(); v != shape.finite_vertices_end(); ++v) {
    const auto kind = shape.classify(typename Shape::Vertex_handle(v));
    if (kind != Shape::EXTERIOR) vertices.push_back({{v->info()}, simplex_class<Shape>(kind)});
  }
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e) {
    const auto kind = shape.classify(*e);
    if (kind == Shape::EXTERIOR) continue;
    edges.push_back({{e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info()},
                     simplex_class<Shape>(kind)});
  }
  for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f) {
    const auto kind = shape.classify(*f);
    if (kind == Shape::EXTERIOR) continue;
    Entry<3> entry{{}, simplex_class<Shape>(kind)};
    for (int n = 0; n < 3; ++n)
      entry.simplex[n] = f->first->vertex((f->second + 1 + n) % 4)->info();
    triangles.push_back(entry);
  }
  for (auto c = shape.finite_cells_begin(); c != shape.finite_cells_end(); ++c) {
    if (shape.classify(typename Shape::Cell_handle(c)) == Shape::EXTERIOR) continue;
    tetrahedra.push_back(
        {{c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()},
         SimplexClass::interior});
  }
  store(std::move(vertices), complex.vertices);
  store(std::move(edges), complex.edges);
  store(std::move(triangles), complex.triangles);
  store(std::move(tetrahedra), complex.tetrahedra);
}

}  // namespace

CgalReference fixed_alpha_shape(const BallSet& balls, double alpha_on_lattice) {
  using Tds = CGAL::Triangulation_data_structure_3<
      CGAL::Fixed_alpha_shape_vertex_base_3<Kernel, IndexedVertex>,
      CGAL::Fixed_alpha_shape_cell_base_3<Kernel, PlainCell>>;
  using Rt = CGAL::Regular_triangulation_3<Kernel, Tds>;
  using Shape = CGAL::Fixed_alpha_shape_3<Rt>;

  CgalReference result;
  const auto points = indexed_points(balls);
  Clock::time_point start = Clock::now();
  Rt rt(points.begin(), points.end());
  result.triangulation_milliseconds = milliseconds_since(start);
  if (rt.dimension() != 3) throw std::invalid_argument("the balls lie in one plane");
  start = Clock::now();
  const Shape shape(rt, alpha_on_lattice);
  result.classification_milliseconds = milliseconds_since(start);
  result.complex.lattice = balls.lattice;
  result.complex.alpha_on_lattice = alpha_on_lattice;
  copy_out(shape, result.complex);
  result.complex.hash = complex_hash(result.complex);
  return result;
}

CgalCells regular_cells(const BallSet& balls, double alpha_on_lattice) {
  CellTriangulation<CGAL::Sequential_tag> triangulation;
  return cells_within(balls, triangulation, alpha_on_lattice);
}

}  // namespace alphascope::testing
