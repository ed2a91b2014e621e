// SPDX-License-Identifier: GPL-3.0-or-later
// A convex polyhedron that planes cut smaller, and its intersection with a ball around the origin.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/predicates/lifted.hpp"

namespace alphascope {

// A plane of the boundary; `normal` is a unit vector that points out.
struct PieceFace {
  Vector3<double> normal;
  double distance;        // of the plane from the origin, negative if the origin is outside
  std::uint32_t made_by;  // a number of the caller
};

// The volume of the intersection of ball and polyhedron, and the area of the sphere inside the
// polyhedron.
struct SharedMeasures {
  double volume = 0, area = 0;
};

// A cut decides by the side of each corner in double precision. Faces share their corners, so the
// surface stays closed whatever is decided, and a wrong side moves it by a rounding error only. For
// the same reason a plane that would cut off no more than rounding errors (kSlack) cuts off
// nothing.
class ConvexPiece {
 public:
  // Starts with a tetrahedron. `face[m]` is opposite corner m. Its distance is 0 exactly if the
  // origin is on it.
  void start(const Vector3<double> (&corner)[4], const PieceFace (&face)[4], bool is_mirrored);

  // Keeps { x : normal . x <= offset }; `length` is the length of `normal`. `made_by` goes to the
  // new face. Returns false if nothing is left.
  bool cut(const Vector3<double>& normal, double offset, double length, std::uint32_t made_by);

  bool cut(const Vector3<double>& normal, double offset, std::uint32_t made_by) {
    return cut(normal, offset, std::sqrt(dot(normal, normal)), made_by);
  }

  // Distance of the farthest corner from the origin.
  double reach() const { return reach_; }

  double volume() const;
  SharedMeasures shared_with_ball(double radius) const;

  // Calls visit(made_by) for each face.
  template <class Visit>
  void for_faces(const Visit& visit) const {
    for (const Loop& loop : loops_) visit(loop.face.made_by);
  }

 private:
  struct Loop {
    PieceFace face;
    std::uint32_t first, count;  // corners, counterclockwise seen from outside
  };
  std::uint32_t crossing(std::uint32_t in, std::uint32_t out);
  void add_loops(const Vector3<double>& normal, double offset, double length,
                 std::uint32_t made_by);
  void forget_corners();
  void measure_reach();
  std::span<const std::uint32_t> corners_of(const Loop& loop) const {
    return {indices_.data() + loop.first, loop.count};
  }

  struct Crossing {
    std::uint32_t in, out;   // corners of the edge that is cut
    std::uint32_t corner;    // corner at the cut
    std::uint32_t next = 0;  // next crossing on the new face
  };
  // Relative to the largest number from which a side is computed: 2^7 roundings.
  static constexpr double kSlack = 0x1p-46;
  std::vector<Vector3<double>> corners_, kept_corners_;
  double reach_ = 0;
  std::vector<double> side_;          // per corner; negative: cut off
  std::vector<std::uint32_t> place_;  // per corner: its index among the kept ones
  std::vector<Loop> loops_, kept_loops_;
  std::vector<std::uint32_t> indices_, kept_indices_;
  std::vector<Crossing> crossings_;
};

}  // namespace alphascope
