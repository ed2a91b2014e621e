// SPDX-License-Identifier: GPL-3.0-or-later
// The empty space of a molecule as a graph of tetrahedra. Ways lead through it from outside to
// outside along an axis. The decision which ways are open is exact; all else is rounded.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/channel/envelope.hpp"
#include "core/clearance/empty_space.hpp"
#include "core/clearance/grown_triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// The region for a way. It leads from outside the envelope of all balls, below a part's middle, to
// outside above it. In the middle third of the part the way stays near the axis. Elsewhere it is
// free.
class WayAxis {
 public:
  // The axis passes through the mean centre of these balls; there must be at least one. `axis` is a
  // unit vector.
  WayAxis(const BallSet& balls, const std::vector<BallIndex>& part, const RealPoint& axis);

  const RealPoint& axis() const { return axis_; }
  double low() const { return low_; }  // range of the part's centres, Å along the axis
  double high() const { return high_; }
  double along(const RealPoint& x) const { return dot(axis_, x); }  // Å
  double from_axis(const RealPoint& x) const;                       // distance, Å

  // -1: in the part's lower third or below; 1: in the upper third or above; 0: in the middle third.
  int zone(const RealPoint& x) const;
  int side(const RealPoint& x) const { return along(x) < (low_ + high_) / 2 ? -1 : 1; }
  // Returns whether x is near the axis: not farther than half the root mean square distance of the
  // part's atoms from the axis at this height.
  bool is_near(const RealPoint& x) const;
  // Returns whether a straight step is near the axis wherever it passes the middle third.
  bool stays_near_axis(const RealPoint& from, const RealPoint& to) const;

 private:
  static constexpr double kSlab = 2;  // Å
  std::size_t slab_of(double along) const;

  RealPoint middle_, axis_;  // Å
  double low_ = 0, high_ = 0;
  std::vector<double> near_;  // Å, for each slab: the distance up to which is_near() holds
};

// A triangle at which a way is narrowest by power distance, with the tetrahedra on both sides.
struct WayCrossing {
  double width_angstrom = 0;  // clearance there
  float power = 0;
  RealPoint place_angstrom;
  std::uint32_t below = 0, above = 0;
};

class WayGraph {
 public:
  // `balls` must be on a lattice that passage_digits() allows, and outlive this object.
  WayGraph(const BallSet& balls, const Envelope& envelope, const RunContext& context);

  // The crossings of the axis, the widest first. On both sides of a crossing the molecule lets a
  // larger sphere out. A ring of balls surrounds it, and its triangle alone closes it as the balls
  // grow.
  std::vector<WayCrossing> crossings(const WayAxis& axis, const CancelToken& cancel);

  // A way from the outside below to the outside above. All tetrahedra but the first and last are
  // within the envelope.
  struct Route {
    std::vector<std::uint32_t> below, above;  // each from the crossing on
    double width_angstrom = 0;                // least clearance, at the crossing or elsewhere
  };
  // The route through a crossing of the last call of crossings(). It is the way of least ∫ dl /
  // clearance² that is nowhere narrower by power distance than the crossing.
  Route route(const WayCrossing& crossing, const CancelToken& cancel) const;

  const RealPoint& corner(std::uint32_t tetrahedron) const { return corner_[tetrahedron]; }
  bool is_outside(std::uint32_t tetrahedron) const { return kind_[tetrahedron] == Kind::outside; }

 private:
  enum class Kind : std::uint8_t { full, inside, outside };
  static constexpr float kShut = -1;

  void set_widths(const CancelToken& cancel);
  double clearance_at_gap(const std::array<BallIndex, 3>& triangle, RealPoint* place) const;
  bool may_pass(std::uint32_t from, std::uint32_t to) const;
  std::vector<std::uint32_t> way_out(std::uint32_t from, float power,
                                     const CancelToken& cancel) const;

  const BallSet& balls_;
  std::shared_ptr<const GrownTriangulation> scene_;
  std::optional<EmptySpace> space_;
  std::vector<Kind> kind_;
  std::vector<RealPoint> corner_;  // Å; only for tetrahedra that are not full
  // For each face the clearance (Å) and the power distance (square lattice units) across it. kShut:
  // no way leads through. The power distance orders ways as K does. The two orders differ where
  // radii differ.
  std::vector<std::array<float, 4>> width_, power_;
  std::vector<std::array<bool, 4>> is_gap_;

  // The axis of the last call of crossings().
  std::optional<WayAxis> axis_;
  std::vector<std::int8_t> zone_;  // WayAxis::zone(); for tetrahedra outside: WayAxis::side()
  // For each tetrahedron the side to which its widest way out leads: -1 below, 1 above, 0 none.
  std::vector<std::int8_t> label_;
};

}  // namespace alphascope
