// The regular triangulation of a set of balls as plain arrays: data only. Who makes it is
// core/triangulation's business, its proof core/verify's.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// What lies across a face of a tetrahedron: another tetrahedron, or the outside, behind one facet
// of the hull. The indices are those of Triangulation::tetrahedra and ::hull.
class Neighbour {
 public:
  static constexpr std::uint32_t kMostIndex = (std::uint32_t{1} << 31) - 1;
  static constexpr Neighbour tetrahedron(std::uint32_t index) { return Neighbour(index); }
  static constexpr Neighbour hull_facet(std::uint32_t index) { return Neighbour(index | kHull); }
  Neighbour() = default;  // not initialised, as elements of result arrays are

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
  // Counterclockwise when seen from outside; the lowest index is the first.
  std::array<BallIndex, 3> balls;
  std::uint32_t tetrahedron;  // the only one that it is a face of

  std::array<BallIndex, 3> ascending() const {
    return {balls[0], std::min(balls[1], balls[2]), std::max(balls[1], balls[2])};
  }
  friend bool operator==(const HullFacet&, const HullFacet&) = default;
};

// Unique: equal powers are decided by CGAL's symbolic perturbation (core/predicates/
// perturbation.hpp), and of balls with the same centre only the largest is a vertex, or the one of
// lowest index among the largest. So the arrays are the same, byte for byte, whoever made them and
// with however many threads. Of balls in one plane, on one line or at one point, the simplices are
// those of a triangulation of that plane, line or point, and there is no hull.
struct Triangulation {
  int dimension = -1;  // of the affine hull of the centres: -1 (no ball) to 3

  // Dimension 3. The balls of each tetrahedron ascend, and the list is in lexicographic order.
  Simplices<4> tetrahedra;
  // neighbours[t][k] lies across the face opposite ball k of tetrahedron t.
  ResultArray<std::array<Neighbour, 4>> neighbours;
  std::vector<HullFacet> hull;  // in lexicographic order of ascending()

  Simplices<3> triangles;  // dimension 2: all of them, ordered as the tetrahedra are
  Simplices<2> edges;      // dimension 1: likewise

  std::vector<BallIndex> vertices;  // any dimension; ascending
  std::vector<BallIndex> hidden;    // the balls that are no vertex; ascending

  friend bool operator==(const Triangulation&, const Triangulation&) = default;
};

}  // namespace alphascope
