// A convex polyhedron that planes cut smaller, and what a ball around the origin shares with it.
#pragma once

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

// Cuts decide by the sign of each corner in double precision. Corners are shared by their faces, so
// the surface stays closed whatever the signs; a wrong one moves it by a rounding error.
class ConvexPiece {
 public:
  // A tetrahedron. `face[m]` is opposite corner m, and has distance 0 exactly when the origin lies
  // on it.
  void start(const Vector3<double> (&corner)[4], const PieceFace (&face)[4], bool is_mirrored);

  // Keeps { x : normal . x <= offset }, with `normal` of any length. Returns false when nothing is
  // left. `made_by` is that of the face that appears.
  bool cut(const Vector3<double>& normal, double offset, std::uint32_t made_by);

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
  void add_loops(const Vector3<double>& normal, double offset, std::uint32_t made_by);
  std::span<const std::uint32_t> corners_of(const Loop& loop) const {
    return {indices_.data() + loop.first, loop.count};
  }

  struct Crossing {
    std::uint32_t in, out;   // corners of the edge that is cut
    std::uint32_t corner;    // where
    std::uint32_t next = 0;  // crossing that follows on the new face
  };
  std::vector<Vector3<double>> corners_;
  std::vector<double> side_;  // >= 0: kept
  std::vector<Loop> loops_, kept_loops_;
  std::vector<std::uint32_t> indices_, kept_indices_;
  std::vector<Crossing> crossings_;
};

}  // namespace alphascope
