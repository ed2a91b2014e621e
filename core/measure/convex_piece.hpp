// A convex polyhedron that planes cut smaller, and what a ball around the origin shares with it.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/predicates/lifted.hpp"

namespace alphascope {

// A plane of the boundary; `normal` is of length 1 and points out.
struct PieceFace {
  Vector3<double> normal;
  double distance;        // of the plane from the origin, negative when the origin is outside
  std::uint32_t made_by;  // whoever cuts says what this means
};

// The volume that the ball and the polyhedron share, and the area of its sphere in there.
struct SharedMeasures {
  double volume = 0, area = 0;
};

// Cuts decide by the side of each corner in double precision. Corners are shared by their faces, so
// the surface stays closed whatever is decided; a wrong side moves it by a rounding error. For the
// same reason a plane that cuts off no more than rounding errors (kSlack) cuts off nothing.
class ConvexPiece {
 public:
  // A tetrahedron. `face[m]` is opposite corner m, and has distance 0 exactly when the origin lies
  // on it.
  void start(const Vector3<double> (&corner)[4], const PieceFace (&face)[4], bool is_mirrored);

  // Keeps { x : normal . x <= offset }, with `normal` of this length. Returns false when nothing is
  // left. `made_by` is that of the face that appears.
  bool cut(const Vector3<double>& normal, double offset, double length, std::uint32_t made_by);

  bool cut(const Vector3<double>& normal, double offset, std::uint32_t made_by) {
    return cut(normal, offset, std::sqrt(dot(normal, normal)), made_by);
  }

  // Distance of the origin from the farthest corner.
  double reach() const { return reach_; }

  double volume() const;
  SharedMeasures shared_with_ball(double radius) const;

  // visit(made_by) of each face.
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
    std::uint32_t corner;    // where
    std::uint32_t next = 0;  // crossing that follows on the new face
  };
  // Of the largest of the numbers that a side is computed from: 2^7 roundings.
  static constexpr double kSlack = 0x1p-46;
  std::vector<Vector3<double>> corners_, kept_corners_;
  double reach_ = 0;
  std::vector<double> side_;          // of each corner; negative ones are cut off
  std::vector<std::uint32_t> place_;  // of each corner among those that are kept
  std::vector<Loop> loops_, kept_loops_;
  std::vector<std::uint32_t> indices_, kept_indices_;
  std::vector<Crossing> crossings_;
};

}  // namespace alphascope
