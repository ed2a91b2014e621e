// SPDX-License-Identifier: GPL-3.0-or-later
// The regular triangulation of a set of balls as plain arrays. core/triangulation makes it, and
// core/verify proves it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/complex/simplices.hpp"

namespace alphascope {

// The neighbour across a face of a tetrahedron: another tetrahedron, or a facet of the hull if the
// face is on the outside. The index is one of Triangulation::tetrahedra or ::hull.
class Neighbour {
 public:
  static constexpr std::uint32_t kMostIndex = (std::uint32_t{1} << 31) - 1;
  static constexpr Neighbour tetrahedron(std::uint32_t index) { return Neighbour(index); }
  static constexpr Neighbour hull_facet(std::uint32_t index) { return Neighbour(index | kHull); }
  Neighbour() = default;  // not initialised, like all elements of result arrays

  constexpr bool is_hull() const { return (code_ & kHull) != 0; }
  constexpr std::uint32_t index() const { return code_ & kMostIndex; }
  friend constexpr bool operator==(Neighbour, Neighbour) = default;

 private:
  static constexpr std::uint32_t kHull = std::uint32_t{1} << 31;
  constexpr explicit Neighbour(std::uint32_t code) : code_(code) {}
  std::uint32_t code_;
};

// A triangle on the boundary of the convex hull of all centres.
struct HullFacet {
  // Counterclockwise when seen from outside, beginning with the lowest index.
  std::array<BallIndex, 3> balls;
  std::uint32_t tetrahedron;  // the only tetrahedron with this face

  std::array<BallIndex, 3> ascending() const {
    return {balls[0], std::min(balls[1], balls[2]), std::max(balls[1], balls[2])};
  }
  friend bool operator==(const HullFacet&, const HullFacet&) = default;
};

struct TriangulationReport;

// The triangulation is unique. CGAL's symbolic perturbation decides equal powers
// (core/predicates/perturbation.hpp). Among balls with the same centre only one is a vertex: the
// largest, and among equal ones the one with the lowest index. So two programs that make it, with
// any number of threads, make arrays that are equal in every byte. For balls in one plane, on one
// line or at one point, the simplices triangulate that plane, line or point, and there is no hull.
struct Triangulation {
  int dimension = -1;  // of the affine hull of the centres: 0 to 3, or -1 without balls

  // Dimension 3. The balls of each tetrahedron ascend, and the list is in lexicographic order.
  Simplices<4> tetrahedra;
  // neighbours[t][k] lies across the face opposite ball k of tetrahedron t.
  ResultArray<std::array<Neighbour, 4>> neighbours;
  std::vector<HullFacet> hull;  // in lexicographic order of ascending()

  Simplices<3> triangles;  // dimension 2 only, in lexicographic order
  Simplices<2> edges;      // dimension 1 only, in lexicographic order

  std::vector<BallIndex> vertices;  // in any dimension; ascending
  std::vector<BallIndex> hidden;    // balls that are no vertex; ascending

  // Who made it, and how (core/triangulation/triangulation_report.hpp). Null: CGAL.
  std::shared_ptr<const TriangulationReport> report;

  // Compares all arrays.
  friend bool operator==(const Triangulation& a, const Triangulation& b) {
    return a.dimension == b.dimension && a.tetrahedra == b.tetrahedra &&
           a.neighbours == b.neighbours && a.hull == b.hull && a.triangles == b.triangles &&
           a.edges == b.edges && a.vertices == b.vertices && a.hidden == b.hidden;
  }
};

}  // namespace alphascope
