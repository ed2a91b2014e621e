// SPDX-License-Identifier: GPL-3.0-or-later
// The two ends of a channel.
#pragma once

#include "core/geometry/real_point.hpp"

namespace alphascope {

// All places and directions are in Å. Places are rounded to the lattice (at most 4 digits).
struct ChannelEnds {
  enum class Kind {
    between,    // two points
    out,        // a point and infinity, by any way
    out_along,  // a point and infinity, without crossing the plane through the point normal to
                // `along`
    // Both ways out along a line: from infinity against `along`, through the plane, to infinity
    // along it. The point is first moved within the plane to a local maximum of clearance.
    through
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
  // A line towards infinity ends where its radius reaches this (Å) and 1.5 times the bottleneck's
  // for the last time. So the line may miss a given point that lies in a place as wide as the
  // outside.
  double end_radius_angstrom = 5;
};

}  // namespace alphascope
