// SPDX-License-Identifier: GPL-3.0-or-later
// Marks the simplices of a proven triangulation that are in K_alpha, from their cofaces. This is
// why the cofaces of a simplex s in the triangulation are enough. The dual face V_s is the part of
// the flat of equal power of its balls that no other ball cuts off. V_s is a convex polytope, and
// its facets are those of the cofaces of s with one more ball. So a point of the flat is in V_s iff
// none of those balls has less power there. With perturbed weights the facets, and V_s with them,
// move by an arbitrarily small amount. So the orthocentre of s is in V_s iff no ball of a coface is
// in conflict with s. Then the alpha value of s is rho; else it is the least of its cofaces.
#include "core/verify/verify_proven.hpp"

#include <tbb/task_arena.h>

#include "core/complex/face_groups.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/verify/verify_orthosphere.hpp"
#include "core/verify/verify_run.hpp"
#include "core/verify/verify_triangulation.hpp"

namespace alphascope {

ProvenTriangulation::ProvenTriangulation(const VerifyBalls& balls, const RunContext& context)
    : balls_(balls), context_(context) {
  const Triangulation triangulation =
      make_cgal_triangulation(balls.balls(), tbb::this_task_arena::max_concurrency(), context);
  proof_ = verify_triangulation(balls.balls(), triangulation, context);
  if (!proof_.ok()) return;
  switch (triangulation.dimension) {
    case 3:
      mark_cells<4>(triangulation.tetrahedra);
      break;
    case 2:
      mark_cells<3>(triangulation.triangles);
      break;
    case 1:
      mark_cells<2>(triangulation.edges);
      break;
    case 0:
      mark_cells<1>({{triangulation.vertices[0]}});
      break;
    default:
      return;  // no ball
  }
  mark_faces<3>();
  mark_faces<2>();
  mark_faces<1>();
}

// Marks the simplices of the highest dimension. No ball is in conflict with them.
template <int N>
void ProvenTriangulation::mark_cells(const Simplices<N>& cells) {
  ProvenSimplices<N>& level = std::get<N - 1>(levels_);
  level.simplices = cells;
  level.attached.assign(cells.size(), 0);
  level.in.assign(cells.size(), 0);
  verify_all(cells.size(), context_, [&](std::size_t n) {
    const ExactRho rho = Orthosphere<N>(balls_.balls(), cells[n]).rho();
    level.in[n] = compare_exact(rho, balls_.alpha()) <= 0;
  });
}

template <int N>
void ProvenTriangulation::mark_faces() {
  const ProvenSimplices<N + 1>& cofaces = std::get<N>(levels_);
  if (cofaces.simplices.empty()) return;
  const FaceGroups<N> groups(cofaces.simplices, context_.cancel);
  ProvenSimplices<N>& level = std::get<N - 1>(levels_);
  level.simplices = groups.faces();
  level.attached.assign(groups.size(), 0);
  level.in.assign(groups.size(), 0);
  verify_all(groups.size(), context_, [&](std::size_t n) {
    const auto& face = level.simplices[n];
    const Orthosphere<N> sphere(balls_.balls(), face);
    bool attached = false, in = false;
    groups.for_cofaces(n, [&](std::uint32_t c) {
      in = in || cofaces.in[c] != 0;
      attached = attached || sphere.side(apex<N>(cofaces.simplices[c], face)) < 0;
    });
    level.attached[n] = attached;
    level.in[n] = in || (!attached && compare_exact(sphere.rho(), balls_.alpha()) <= 0);
  });
}

}  // namespace alphascope
