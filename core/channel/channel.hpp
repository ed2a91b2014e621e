// SPDX-License-Identifier: GPL-3.0-or-later
// Channels by true clearance: which sphere can just move from one place to another outside all
// balls. They also tell where larger spheres get stuck, and how wide the way is. Clearance at x is
// min |x - c| - r over all balls (Å). Radii are used as they are, without a solvent radius. The
// bottleneck is exact and depends neither on alpha nor on a solvent radius. It does not depend on
// the line either, which is drawn through the channel afterwards.
#pragma once

#include <stdexcept>
#include <vector>

#include "core/channel/channel_ends.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;
struct ChannelEnds;

struct ChannelSample {
  RealPoint position_angstrom;
  double radius_angstrom = 0;  // clearance at the position
  double along_angstrom = 0;   // length of the line up to the position
};

// The kind of the bottleneck.
enum class ChannelLimit {
  passage,  // a place between balls
  end,      // a given point; the way is wider everywhere else
  // Two balls and the plane that the way must not cross. Another point in the channel or another
  // direction may find a wider way.
  plane
};

struct Channel {
  // The largest multiple of `step_angstrom` by which all radii can grow while both ends stay
  // connected. Decided exactly. Negative if not even a point can pass: radii must then shrink.
  double widest_angstrom = 0;
  double step_angstrom = 0;  // 0.001 Å, or the unit of a coarser lattice

  ChannelLimit limit = ChannelLimit::passage;
  std::size_t bottleneck = 0;       // index of its sample; no other sample has a smaller radius
  std::vector<BallIndex> touching;  // balls within 0.01 Å of touching its sphere; ascending

  // Samples are at most 0.1 Å apart. Between the ends each one is at a local maximum of clearance
  // in the plane normal to the line. A place without a maximum near is the exception.
  std::vector<ChannelSample> samples;
  double length_angstrom = 0;
  double end_radius_angstrom = 0;  // the radius at which the line towards infinity ends

  bool is_open() const { return widest_angstrom >= 0; }
  const ChannelSample& narrowest() const { return samples[bottleneck]; }
  int triangulations = 0;  // number of triangulations of all balls, the main cost
};

// Thrown if a given point lies in a ball.
struct ChannelEndCovered : std::invalid_argument {
  ChannelEndCovered(const RealPoint& place, BallIndex covering, double depth);
  RealPoint place_angstrom;
  BallIndex ball;         // the ball that covers it most
  double depth_angstrom;  // depth of the point below that ball's surface
};

// The plane of `out_along` and `through` is the surface of a ball. Its radius is 30,000 Å (3,000 Å
// on a lattice of 4 digits). At x Å from the point this surface is x² / 60,000 Å behind the plane.
// Works in the caller's task arena. The result has the same bits for any order of the balls and any
// number of threads. Throws ChannelEndCovered and Cancelled. Throws std::invalid_argument in four
// cases: no balls; a direction of no length; a plane in which no balls enclose the point; an end
// that is 100,000 Å away from the balls.
Channel find_channel(const BallSet& balls, const ChannelEnds& ends, const RunContext& context = {});

}  // namespace alphascope
