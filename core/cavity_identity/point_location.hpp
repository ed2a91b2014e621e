// In which tetrahedron of a triangulation does a point lie? Decided exactly. A point on a triangle,
// an edge or a vertex counts as if it were moved by an infinitesimal: along x, by infinitely less
// along y, by infinitely less again along z. So every point is in one tetrahedron or outside the
// hull, whatever the order of the balls and wherever the search begins.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/lattice.hpp"

namespace alphascope {

// The place (x, y, z) / times, lattice units of the balls. The sum of a tetrahedron's four corners
// and times = 4 is its centroid, which is on no lattice.
struct LatticePlace {
  std::int64_t x = 0, y = 0, z = 0;
  std::int32_t times = 1;  // 1 to 4
};

// A point of a lattice on another one that is as fine or finer.
LatticePlace place_on(const Lattice& finer, const LatticePoint& point, const Lattice& lattice);

// Goes from tetrahedron to tetrahedron, from `start` to the one that holds a place, no farther away
// than lattice coordinates go; kOutsideHull. The way has no circle: a regular triangulation, seen
// from a point, lies behind itself nowhere (H. Edelsbrunner, An acyclicity theorem for cell
// complexes in d dimensions, Combinatorica 10, 1990).
inline constexpr std::uint32_t kOutsideHull = ~std::uint32_t{0};
std::uint32_t walk_to(const LatticePlace& place, const BallSet& balls,
                      const Triangulation& triangulation, std::uint32_t start);

// Both the balls and their triangulation must live longer. Below dimension 3 every point is
// outside.
class PointLocator {
 public:
  static constexpr std::uint32_t kOutside = kOutsideHull;

  PointLocator(const BallSet& balls, const Triangulation& triangulation);

  // By walk_to(), from one of the tetrahedra near the point or, quicker where it is known, from
  // `start`.
  std::uint32_t find(const LatticePlace& place) const;
  std::uint32_t find(const LatticePlace& place, std::uint32_t start) const;

 private:
  bool is_in_box(const LatticePlace& place) const;
  std::size_t cell_of(const LatticePlace& place) const;  // within the box
  void set_box();
  void set_cells();

  const BallSet& balls_;
  const Triangulation& triangulation_;
  LatticePoint low_{}, high_{};  // the box of all vertices
  // A tetrahedron near each cell of a grid over the box.
  double side_ = 1;  // lattice units
  std::size_t cells_x_ = 1, cells_y_ = 1, cells_z_ = 1;
  std::vector<std::uint32_t> near_;
};

}  // namespace alphascope
