// Channels by true clearance: how large a sphere can walk from one place to another outside all
// balls, where it gets stuck, and how wide its way is. Clearance at x is min |x - c| - r over all
// balls (Å; radii as they are, without a solvent). The number is exact; it does not depend on any
// alpha or solvent radius, and not on the line, which is drawn through the channel afterwards.
#pragma once

#include <stdexcept>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// All places and directions in Å. Places are rounded to the lattice (of at most 4 digits).
struct ChannelEnds {
  enum class Kind {
    between,    // two points
    out,        // a point and infinity, any way out
    out_along,  // a point and infinity, without going behind the plane through it normal to `along`
    through     // both ways out along a line: from infinity against `along`, through the plane, to
                // infinity along it. The point is first moved within the plane to a place where
                // clearance has a local maximum.
  };
  static ChannelEnds between(const RealPoint& a, const RealPoint& b) {
    return {Kind::between, a, b, {}};
  }
  static ChannelEnds out(const RealPoint& from) { return {Kind::out, from, {}, {}}; }
  static ChannelEnds out_along(const RealPoint& from, const RealPoint& along) {
    return {Kind::out_along, from, {}, along};
  }
  static ChannelEnds through(const RealPoint& point, const RealPoint& along) {
    return {Kind::through, point, {}, along};
  }

  Kind kind = Kind::out;
  RealPoint from, to, along;
  // Towards infinity the line ends where its radius reaches this, and 1.5 times the bottleneck's,
  // for the last time; so a given point in a place as wide as outside may not be on it.
  double end_radius_angstrom = 5;
};

struct ChannelSample {
  RealPoint position_angstrom;
  double radius_angstrom = 0;  // its clearance
  double along_angstrom = 0;   // length of the line up to it
};

// What the bottleneck is.
enum class ChannelLimit {
  passage,  // a place between balls
  end,      // a given point: the way is wider everywhere else
  plane  // the plane that the way must not cross, and two balls: another point in the channel, or
         // another direction, may find a wider way
};

struct Channel {
  // The largest multiple of `step_angstrom` by which all radii can grow with the ends still
  // connected: decided exactly. Negative where there is no way even for a point; then radii shrink.
  double widest_angstrom = 0;
  double step_angstrom = 0;  // 0.001, or the unit of a coarser lattice

  ChannelLimit limit = ChannelLimit::passage;
  std::size_t bottleneck = 0;       // its sample; no other has a smaller radius
  std::vector<BallIndex> touching;  // surfaces there within 0.01 Å of touching; ascending

  // At most 0.1 Å apart. Between its ends each one is at a local maximum of clearance in the plane
  // normal to the line, where there is one near.
  std::vector<ChannelSample> samples;
  double length_angstrom = 0;
  double end_radius_angstrom = 0;  // the radius that ends it towards infinity

  bool is_open() const { return widest_angstrom >= 0; }
  const ChannelSample& narrowest() const { return samples[bottleneck]; }
  int triangulations = 0;  // of all balls: what the answer cost
};

// A given point is not outside all balls.
struct ChannelEndCovered : std::invalid_argument {
  ChannelEndCovered(const RealPoint& place, BallIndex covering, double depth);
  RealPoint place_angstrom;
  BallIndex ball;         // the one that covers it most
  double depth_angstrom;  // how far the point is below its surface
};

// The plane that `out_along` and `through` may not cross is the surface of a ball of 30,000 Å
// (3,000 on a lattice of 4 digits): x Å from the point it is x² / 60,000 Å behind the plane.
// Works in the caller's task arena. The same bits for any order of the balls and any number of
// threads. Throws ChannelEndCovered; std::invalid_argument for no balls,
// for a direction of no length, for a plane that is open sideways, or where an end is 100,000 Å
// away from the balls; Cancelled.
Channel find_channel(const BallSet& balls, const ChannelEnds& ends, const RunContext& context = {});

}  // namespace alphascope
