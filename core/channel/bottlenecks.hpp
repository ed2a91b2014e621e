// Where the widest ways from many places out of a molecule are narrowest: as channel.hpp's
// bottleneck, coarser, and with one search for all places. Each triangulation of all grown balls
// answers for every place at once.
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// What RunContext::progress is told; the share is that of the places that are done.
inline constexpr std::string_view kBottlenecksStage = "bottlenecks";

struct Bottleneck {
  enum class Kind {
    passage,  // a place between balls
    end,      // the place itself: its way out is wider everywhere else
    closed,   // there is no way out, not even for a point
    covered   // the place is not outside all balls
  };
  Kind kind = Kind::covered;
  // The largest sphere that can walk out has a radius from `at_least` to less than `below`: decided
  // exactly. `radius` is between both, mostly right to the last digit.
  double at_least_angstrom = 0, below_angstrom = 0, radius_angstrom = 0;
  RealPoint place_angstrom;         // of a passage, and of an end
  std::vector<BallIndex> touching;  // within 0.01 Å there; ascending

  bool is_open() const { return kind == Kind::passage || kind == Kind::end; }
};

struct Bottlenecks {
  std::vector<Bottleneck> of;  // the places, in their order
  int triangulations = 0;      // of all balls: what it cost
};

// How far `at_least` and `below` are apart, unless the lattice is coarser.
inline constexpr double kBottleneckStepAngstrom = 0.01;

// From each place (Å) out, by any way; radii as they are. Places are rounded to the lattice (of at
// most 4 digits). Works in the caller's task arena; the same for any number of threads. Throws
// Cancelled, and std::invalid_argument as find_channel().
Bottlenecks find_bottlenecks(const BallSet& balls, const std::vector<RealPoint>& places_angstrom,
                             const RunContext& context = {});

}  // namespace alphascope
