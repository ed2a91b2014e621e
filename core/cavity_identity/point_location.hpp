// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the tetrahedron of a triangulation that contains a point, exactly. A point on a triangle,
// edge or vertex counts as if moved by an infinitesimal along x. The move along y is infinitely
// smaller, and the move along z again. So every point is in one tetrahedron or outside the hull.
// The order of the balls and the start of the search have no influence.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {

// The point (x, y, z) / times, in lattice units of the balls. The centroid of a tetrahedron is the
// sum of its corners with times = 4. It need not be on a lattice.
struct LatticePlace {
  std::int64_t x = 0, y = 0, z = 0;
  std::int32_t times = 1;  // 1 to 4
};

// A point of `lattice` on a lattice that is as fine or finer.
LatticePlace place_on(const Lattice& finer, const LatticePoint& point, const Lattice& lattice);

// Walks from tetrahedron `start` to the one that contains `place`, or returns kOutsideHull. The
// place must be within the range of lattice coordinates. The walk ends: a regular triangulation
// seen from a point has no cycle of tetrahedra behind each other (H. Edelsbrunner, An acyclicity
// theorem for cell complexes in d dimensions, Combinatorica 10, 1990).
inline constexpr std::uint32_t kOutsideHull = ~std::uint32_t{0};
std::uint32_t walk_to(const LatticePlace& place, const BallSet& balls,
                      const Triangulation& triangulation, std::uint32_t start);

// The balls and their triangulation must outlive this object. Below dimension 3 every point is
// outside.
class PointLocator {
 public:
  static constexpr std::uint32_t kOutside = kOutsideHull;

  // Works in the caller's task arena.
  PointLocator(const BallSet& balls, const Triangulation& triangulation);

  // Walks from a tetrahedron near the point. The second form walks from `start`, which is faster if
  // it is near.
  std::uint32_t find(const LatticePlace& place) const;
  std::uint32_t find(const LatticePlace& place, std::uint32_t start) const;

 private:
  bool is_in_box(const LatticePlace& place) const;
  std::size_t cell_of(const LatticePlace& place) const;  // the place must be within the box
  void set_box();
  void set_cells();

  const BallSet& balls_;
  const Triangulation& triangulation_;
  LatticePoint low_{}, high_{};  // box of all vertices
  // For each cell of a grid over the box a tetrahedron near it.
  double side_ = 1;  // length of a cell, lattice units
  std::size_t cells_x_ = 1, cells_y_ = 1, cells_z_ = 1;
  std::vector<std::uint32_t> near_;
};

}  // namespace alphascope
