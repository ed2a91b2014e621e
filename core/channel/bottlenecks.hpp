// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where the widest way out of a molecule is narrowest, for many places at once. The result is
// that of channel.hpp in coarser steps. Each triangulation of the grown balls serves all places.
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// The stage name given to RunContext::progress. The share is the share of finished places.
inline constexpr std::string_view kBottlenecksStage = "bottlenecks";

struct Bottleneck {
  enum class Kind {
    passage,  // a place between balls
    end,      // the place itself; its way out is wider everywhere else
    closed,   // no way out, not even for a point
    covered   // the place lies in a ball
  };
  Kind kind = Kind::covered;
  // The largest sphere that can leave has a radius of at least `at_least` and less than `below`.
  // Both bounds are exact. `radius` lies between them and is mostly right to the last digit.
  double at_least_angstrom = 0, below_angstrom = 0, radius_angstrom = 0;
  RealPoint place_angstrom;         // of the narrowest place; set for passage and end
  std::vector<BallIndex> touching;  // balls within 0.01 Å of touching the sphere there; ascending

  bool is_open() const { return kind == Kind::passage || kind == Kind::end; }
};

struct Bottlenecks {
  std::vector<Bottleneck> of;  // one for each place, in their order
  int triangulations = 0;      // number of triangulations of all balls, the main cost
};

// The distance from `at_least` to `below` (Å), unless the lattice unit is larger.
inline constexpr double kBottleneckStepAngstrom = 0.01;

// Finds the bottleneck from each place (Å) to the outside, by any way. Radii are used as they are,
// without a solvent radius. Places are rounded to the lattice (at most 4 digits). Works in the
// caller's task arena; the result does not depend on the number of threads. Throws Cancelled, and
// std::invalid_argument as find_channel() does.
Bottlenecks find_bottlenecks(const BallSet& balls, const std::vector<RealPoint>& places_angstrom,
                             const RunContext& context = {});

}  // namespace alphascope
