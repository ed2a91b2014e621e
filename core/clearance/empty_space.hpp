// SPDX-License-Identifier: GPL-3.0-or-later
// The space that a union of balls leaves empty. It consists of those tetrahedra and triangles of
// the regular triangulation that alpha complex K of alpha 0 lacks. Two points outside the balls are
// connected by a curve outside them iff such tetrahedra and triangles connect them. The reason: the
// union can be shrunk to K, a part of it, so both leave the same components empty.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Parameters of a way's cost. Clearance here is the power distance turned into a length, plus the
// growth of the radii. Lattice units.
struct WayCost {
  double grown;
  double enough;       // clearance above this lowers the cost no further
  BallIndex ball_end;  // balls from this index on do not narrow a way
};

// Gives the width of a way at a gap (lattice units). A gap is a triangle that is narrower than the
// way on both sides. Returns nothing if the width is unknown. Needed because the triangulation
// orders places by power distance, not by clearance.
struct WayWidth {
  std::function<std::optional<double>(const std::array<BallIndex, 3>& gap)> at_gap;
  double grown;  // as in WayCost
  BallIndex ball_end;
};

// Answers questions on empty space. Each decision is exact and made on demand, because a search
// sees only a part of the triangulation. The balls and their triangulation, of dimension 3, must
// outlive this object.
class EmptySpace {
 public:
  // Stands for infinity: beyond the hull of the centres.
  static constexpr BallIndex kOutside = ~BallIndex{0};

  EmptySpace(const BallSet& balls, const Triangulation& triangulation)
      : balls_(balls), triangulation_(triangulation) {}

  bool is_empty(std::uint32_t tetrahedron) const;
  // Returns whether a curve can pass through face k between two empty tetrahedra. A face of the
  // hull leads outside.
  bool is_open(std::uint32_t tetrahedron, std::size_t k) const;
  // Returns whether an open face of this tetrahedron is on the hull.
  bool leads_out(std::uint32_t tetrahedron) const;

  // A way is a list of empty tetrahedra; each shares an open face with the next. Its ends are balls
  // of radius 0 outside all others. Such a ball is in the triangulation, and the tetrahedra around
  // it are empty with open faces between. The reason: its power cell is convex and outside the
  // other balls. So a straight line leads from it to any corner of the cell.
  using Way = std::vector<std::uint32_t>;

  // A way whose least clearance is largest. Whether there is a way is exact. Clearances are
  // rounded, and those of gaps are guesses. `to` may be kOutside. Throws Cancelled.
  std::optional<Way> widest_way(BallIndex from, BallIndex to, const WayWidth& width,
                                const CancelToken& cancel) const;

  // The width of the widest way from a tetrahedron to the outside, and where it is narrowest.
  // Lattice units, rounded as in widest_way(). The decision which tetrahedra have a way is exact.
  struct WayOut {
    double width;  // minus infinity if no way leads out or the tetrahedron is not empty
    // The face of least width on the way. Tetrahedron kNoFace: no face narrows it.
    static constexpr std::uint32_t kNoFace = ~std::uint32_t{0};
    std::uint32_t tetrahedron;
    std::uint32_t face;
  };
  // One WayOut for each tetrahedron. Throws Cancelled.
  std::vector<WayOut> widest_ways_out(const WayWidth& width, const CancelToken& cancel) const;

  // The width, rounded as in widest_way(), and the cost of a way across an open face between empty
  // tetrahedra.
  double width_across(std::uint32_t tetrahedron, std::size_t k, const WayWidth& width) const;
  double cost_across(std::uint32_t tetrahedron, std::size_t k, const WayCost& cost) const;

  // Returns whether a way across this face is narrowest on it. Then no ball conflicts with the
  // smallest orthosphere of the face.
  bool is_gap(std::uint32_t tetrahedron, std::size_t k) const;
  std::array<BallIndex, 3> face(std::uint32_t tetrahedron, std::size_t k) const;

  // The following are for the triangle of a gap.
  bool is_open_gap(const std::array<BallIndex, 3>& gap) const;
  // Returns whether its edges are in K before it is, as the balls grow. It then enters K alone and
  // closes a tunnel or a void.
  bool is_ringed_gap(const std::array<BallIndex, 3>& gap) const;
  // The width by power distance, for a gap whose width is not known otherwise. Lattice units.
  double width_by_power(const std::array<BallIndex, 3>& gap, double grown,
                        BallIndex ball_end) const;

  // The way of least length / clearance² along the edges of the power diagram. Throws Cancelled.
  std::optional<Way> cheapest_way(BallIndex from, BallIndex to, const WayCost& cost,
                                  const CancelToken& cancel) const;

  // The gaps on a way: triangles that are narrower than the way on both sides, each as its three
  // balls.
  std::vector<std::array<BallIndex, 3>> gaps(const Way& way) const;

  // The orthocentre, a corner of the power diagram; lattice units. The segments between the corners
  // of consecutive tetrahedra of a way are outside all balls.
  RealPoint corner(std::uint32_t tetrahedron) const;

 private:
  double width_of(double power, std::span<const BallIndex> balls, double grown,
                  BallIndex ball_end) const;
  double largest_radius(std::span<const BallIndex> balls, BallIndex end) const;
  // Power distance of its corner, square lattice units.
  double power(std::uint32_t tetrahedron) const;
  template <class Relax>
  std::optional<Way> least_way(BallIndex from, BallIndex to, const CancelToken& cancel,
                               const Relax& relax) const;

  const BallSet& balls_;
  const Triangulation& triangulation_;
};

}  // namespace alphascope
