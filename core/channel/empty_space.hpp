// What a union of balls leaves empty, as the tetrahedra and triangles of its regular triangulation
// that are not in the alpha complex K of alpha 0. A path through such tetrahedra, across such
// triangles, exists between two points outside the balls iff a curve outside the balls does: K is a
// part of the union that the union can be shrunk to, so both leave the same components empty.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// What a way costs. Clearance is here the power distance made a length, plus what the radii of the
// balls were grown by. Lattice units.
struct WayCost {
  double grown;
  double enough;       // a larger clearance is worth no more
  BallIndex ball_end;  // balls from here on do not narrow a way
};

// How wide a way is at a triangle that is narrower than it is on both sides (lattice units);
// nothing where that is not known. The triangulation orders places by power distance, not by
// clearance.
struct WayWidth {
  std::function<std::optional<double>(const std::array<BallIndex, 3>& gap)> at_gap;
  double grown;  // as in WayCost
  BallIndex ball_end;
};

// Each decision is exact and made when it is asked for; a search sees only a part of the
// triangulation. Both the balls and their triangulation, of dimension 3, must live longer.
class EmptySpace {
 public:
  static constexpr BallIndex kOutside = ~BallIndex{0};  // the hull of the centres: infinity

  EmptySpace(const BallSet& balls, const Triangulation& triangulation)
      : balls_(balls), triangulation_(triangulation) {}

  bool is_empty(std::uint32_t tetrahedron) const;
  // Can one pass through face k of this tetrahedron, where the tetrahedra on both sides are empty?
  // A face of the hull leads out.
  bool is_open(std::uint32_t tetrahedron, std::size_t k) const;
  // Is one outside the hull behind an open face of this tetrahedron?
  bool leads_out(std::uint32_t tetrahedron) const;

  // Empty tetrahedra; each shares an open face with the next. It goes from one end to another:
  // balls of radius 0 outside all others. Those are in the triangulation, and all of its tetrahedra
  // around them are empty, with open faces between: the power cell of such a ball, which is convex,
  // is outside the other balls. So a curve goes straight from it to any of the cell's corners.
  using Way = std::vector<std::uint32_t>;

  // Of all ways, one whose least clearance is largest; clearances are rounded and those of gaps are
  // guesses, whether there is a way at all is exact. `to` may be kOutside. Throws Cancelled.
  std::optional<Way> widest_way(BallIndex from, BallIndex to, const WayWidth& width,
                                const CancelToken& cancel) const;

  // How wide the widest way from each tetrahedron to far outside is, and where it is narrowest.
  // Lattice units, rounded as in widest_way(); which tetrahedra have one is exact.
  struct WayOut {
    double width;  // minus infinity: none leads out, or the tetrahedron is not empty
    // The face of least width on the way; tetrahedron kNoFace: none narrows it.
    static constexpr std::uint32_t kNoFace = ~std::uint32_t{0};
    std::uint32_t tetrahedron;
    std::uint32_t face;
  };
  // Throws Cancelled.
  std::vector<WayOut> widest_ways_out(const WayWidth& width, const CancelToken& cancel) const;

  // How wide a way is across an open face between empty tetrahedra, rounded as in widest_way(), and
  // what it costs there.
  double width_across(std::uint32_t tetrahedron, std::size_t k, const WayWidth& width) const;
  double cost_across(std::uint32_t tetrahedron, std::size_t k, const WayCost& cost) const;

  // Is the way across this face narrowest between its balls, in the plane of their centres?
  bool is_gap(std::uint32_t tetrahedron, std::size_t k) const;
  // And do all three balls close it from their sides, so that their edges stand before it closes?
  // Then its triangle enters K by itself as the balls grow, and closes a tunnel or a void.
  bool is_ringed_gap(std::uint32_t tetrahedron, std::size_t k) const;
  std::array<BallIndex, 3> face(std::uint32_t tetrahedron, std::size_t k) const;

  // Of all ways, the one of least length / clearance², along the edges of the power diagram. Throws
  // Cancelled.
  std::optional<Way> cheapest_way(BallIndex from, BallIndex to, const WayCost& cost,
                                  const CancelToken& cancel) const;

  // The triangles on a way that are narrower than it is on both their sides, as the balls they are
  // between.
  std::vector<std::array<BallIndex, 3>> gaps(const Way& way) const;

  // The orthocentre: the corner of the power diagram, lattice units. The segments between those of
  // a way's tetrahedra are outside all balls.
  RealPoint corner(std::uint32_t tetrahedron) const;

 private:
  double largest_radius(std::span<const BallIndex> balls, BallIndex end) const;
  double power(std::uint32_t tetrahedron) const;  // of its corner, square lattice units
  template <class Relax>
  std::optional<Way> least_way(BallIndex from, BallIndex to, const CancelToken& cancel,
                               const Relax& relax) const;

  const BallSet& balls_;
  const Triangulation& triangulation_;
};

}  // namespace alphascope
