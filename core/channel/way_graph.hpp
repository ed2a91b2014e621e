// The empty space of a molecule as a graph of tetrahedra, and the ways through it that lead from
// outside to outside along an axis. Beside which ways are open, all is rounded.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/channel/empty_space.hpp"
#include "core/channel/envelope.hpp"
#include "core/channel/grown_scene.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Where a way may lead: from outside the envelope of all balls, below the middle of a part, to
// outside above it. In the middle third of the part it keeps near the axis; beyond, it is free.
class WayAxis {
 public:
  // Through the middle of these balls, of which there must be one. `axis`: a unit vector.
  WayAxis(const BallSet& balls, const std::vector<BallIndex>& part, const RealPoint& axis);

  const RealPoint& axis() const { return axis_; }
  double low() const { return low_; }  // of the part's centres, Å along the axis
  double high() const { return high_; }
  double along(const RealPoint& x) const { return dot(axis_, x); }  // Å
  double from_axis(const RealPoint& x) const;                       // Å

  // -1 and 1: in the lower and the upper third of the part, or beyond; 0: in between.
  int zone(const RealPoint& x) const;
  int side(const RealPoint& x) const { return along(x) < (low_ + high_) / 2 ? -1 : 1; }
  // Nearer to the axis than half of what the part's atoms are at this height, in square mean.
  bool is_near(const RealPoint& x) const;
  // Is a straight step near the axis where it passes the middle third?
  bool may_lead(const RealPoint& from, const RealPoint& to) const;

 private:
  static constexpr double kSlab = 2;  // Å
  std::size_t slab_of(double along) const;

  RealPoint middle_, axis_;  // Å
  double low_ = 0, high_ = 0;
  std::vector<double> near_;  // Å, of each slab
};

// A triangle at which a way is narrowest by power, and the tetrahedra before and behind it.
struct WayCrossing {
  double width_angstrom = 0;  // the clearance there
  float power = 0;
  RealPoint place_angstrom;
  std::uint32_t below = 0, above = 0;
};

class WayGraph {
 public:
  // `balls` on a lattice that passage_digits() allows. It must live longer.
  WayGraph(const BallSet& balls, const Envelope& envelope, const RunContext& context);

  // Each is narrowest there: on both its sides the molecule lets something larger out. A ring of
  // balls is around it, which nothing else closes as the balls grow. The widest is the first.
  std::vector<WayCrossing> crossings(const WayAxis& axis, const CancelToken& cancel);

  // From outside, below, to outside, above. Between its ends all are within the envelope.
  struct Route {
    std::vector<std::uint32_t> below, above;  // from the crossing on
    double width_angstrom = 0;                // the least clearance, at the crossing or elsewhere
  };
  // Through a crossing of the last call of crossings(): the way of least resistance,
  // ∫ dl / clearance², that is nowhere narrower than the crossing by power.
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
  std::shared_ptr<const GrownScene> scene_;
  std::optional<EmptySpace> space_;
  std::vector<Kind> kind_;
  std::vector<RealPoint> corner_;  // Å; of those that are not full
  // Across each face, kShut where it is shut: the clearance, Å, and the power that orders ways as K
  // does, square lattice units. The two order them differently where radii differ.
  std::vector<std::array<float, 4>> width_, power_;
  std::vector<std::array<bool, 4>> is_gap_;

  // Of the last axis.
  std::optional<WayAxis> axis_;
  std::vector<std::int8_t> zone_;  // as WayAxis::zone(); of those outside, the side
  std::vector<std::int8_t>
      label_;  // -1, 1: the way out of least narrowness is below, above; 0: none
};

}  // namespace alphascope
