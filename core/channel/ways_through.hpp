// The ways through a molecule: from outside to outside, found without a place to begin at. Each is
// a channel with its bottleneck and line.
#pragma once

#include <string_view>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// What RunContext::progress is told.
inline constexpr std::string_view kWaysStage = "ways through";

// What a way may lead through: the whole, a chain, equal chains. Its balls; there must be one.
using WayPart = std::vector<BallIndex>;

// How far the line of a channel leads through all balls along a direction, Å, from centre to
// centre.
struct WayCover {
  double covered_angstrom = 0, whole_angstrom = 0;

  // What leads through less of the whole is a part of a way.
  static constexpr double kWholeShare = 0.75;
  double share() const { return whole_angstrom > 0 ? covered_angstrom / whole_angstrom : 0; }
  bool is_whole() const { return share() >= kWholeShare; }
};
// In the direction from end to end.
WayCover cover_of(const BallSet& balls, const Channel& channel);

struct WayThrough {
  Channel channel;
  std::size_t part = 0;  // of those that were asked about
  RealPoint axis;        // unit vector; the line leads along it, and the part lies around it
  // Along the axis. The line ends in the open, where nothing of what the way leads through is
  // narrower; so it covers less than the whole where the mouths are wide.
  WayCover cover;
  double part_angstrom = 0;       // what the centres of the part span along the axis
  std::vector<BallIndex> lining;  // that all but touch a sphere of its line; ascending
};

inline constexpr std::size_t kMostWays = 5, kMostParts = 64;

struct WaysThrough {
  // The best first: those that lead through most of the whole, then those with the larger
  // bottleneck (to 0.01 Å), then the longer ones.
  std::vector<WayThrough> ways;
  std::size_t parts_left_out = 0;  // of more than kMostParts
};

// Looks along the axes of each part: the first part is the whole, and its axes are looked along in
// the others, too. A way leads from outside the convex hull (roughly) to outside it, below and
// above the middle of a part, and keeps near the part's axis in the middle third of its length. At
// its bottleneck a ring of balls is around it: grooves are no ways. Ways that are closed even for a
// point are not found. Of ways that share half of their length only the widest is listed.
// Radii as they are. Which ways are open is decided exactly; what is widest, by clearances between
// three balls. Works in the caller's task arena; the same for any order of the balls and any number
// of threads. Throws Cancelled, and std::invalid_argument for no balls, a part without balls, and
// balls that are too far apart.
WaysThrough find_ways_through(const BallSet& balls, const std::vector<WayPart>& parts,
                              const RunContext& context = {});

}  // namespace alphascope
