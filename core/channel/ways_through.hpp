// SPDX-License-Identifier: GPL-3.0-or-later
// The ways through a molecule from outside to outside, found without a given place. Each way is a
// channel with its bottleneck and line.
#pragma once

#include <string_view>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

struct BallSet;
struct RunContext;

// The stage name given to RunContext::progress.
inline constexpr std::string_view kWaysStage = "ways through";

// The balls that a way may lead through: the whole, a chain, or equal chains. Not empty.
using WayPart = std::vector<BallIndex>;

// The extent of all balls along a direction, and how much of it the line of a channel covers. Å,
// from centre to centre.
struct WayCover {
  double covered_angstrom = 0, whole_angstrom = 0;

  // A channel that covers a smaller share of the whole does not count as a way through it.
  static constexpr double kWholeShare = 0.75;
  double share() const { return whole_angstrom > 0 ? covered_angstrom / whole_angstrom : 0; }
  bool is_whole() const { return share() >= kWholeShare; }
};
// The cover along the direction from the line's first to its last place.
WayCover cover_of(const BallSet& balls, const Channel& channel);

struct WayThrough {
  Channel channel;
  std::size_t part = 0;  // index in the given list of parts
  RealPoint axis;        // unit vector along which the line leads and about which the part lies
  // The cover along the axis. The line ends where it is wider than anywhere inside the part. So it
  // covers less than the whole if the openings at the ends are wide.
  WayCover cover;
  double part_angstrom = 0;       // extent of the part's centres along the axis
  std::vector<BallIndex> lining;  // balls within 0.5 Å of touching a sphere of the line; ascending
};

inline constexpr std::size_t kMostWays = 5, kMostParts = 64;

struct WaysThrough {
  // The best first: ways that cover most of the whole, then by larger bottleneck (to 0.01 Å), then
  // by length.
  std::vector<WayThrough> ways;
  std::size_t parts_left_out = 0;  // number of parts beyond kMostParts, which were ignored
};

// Searches along the axes of each part. The first part is the whole; its axes are also searched in
// the others. A way leads from outside the convex hull (roughly), below a part's middle, to outside
// it above that middle. In the middle third it stays near the part's axis. A ring of balls
// surrounds its bottleneck, so grooves do not count. Ways through which not even a point can pass
// are not found. Of ways whose bottlenecks are within 3 Å of each other, or that share half of the
// tetrahedra of the shorter one, only the best is listed.
//
// Radii are used as they are. The decision which ways are open is exact. Their widths come from
// clearances between three balls. Works in the caller's task arena. The result is the same for any
// order of the balls and any number of threads. Throws Cancelled. Throws std::invalid_argument if
// there are no balls, if a part is empty, or if the balls are too far apart.
WaysThrough find_ways_through(const BallSet& balls, const std::vector<WayPart>& parts,
                              const RunContext& context = {});

}  // namespace alphascope
