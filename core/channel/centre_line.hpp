// SPDX-License-Identifier: GPL-3.0-or-later
// The centre line of a channel. A curve outside all balls is moved until its clearance has a local
// maximum in the planes normal to it.
#pragma once

#include <string_view>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/channel/envelope.hpp"
#include "core/clearance/clearance.hpp"

namespace alphascope {

// The stage name given to RunContext::progress while the line moves.
inline constexpr std::string_view kCentreLineStage = "centre line";

struct LineStart {
  std::vector<RealPoint> curve;  // Å; at least two places
  // Whether the first and the last place stay. A free end is cut off where clearance reaches
  // `end_radius_angstrom` (Å) for the last time.
  bool first_fixed = true, last_fixed = true;
  double end_radius_angstrom = 5;
};

// cut_at_least_clearance() cuts a curve at its narrowest place. No other place of the curve is
// narrower by more than this (Å).
inline constexpr double kLeastClearanceError = 2.5e-4;
struct CutCurve {
  // Both contain the place of the cut: as the last and the first point.
  std::vector<RealPoint> before, after;
};
CutCurve cut_at_least_clearance(const Clearance& clearance, const std::vector<RealPoint>& curve,
                                const CancelToken& cancel);

// Returns positions and radii at most `kSpacingAngstrom` apart (Å), without lengths along the line.
// A place outside the envelope that is wider than the end radius has no middle and stays. Works in
// the caller's task arena; does not depend on the number of threads. Throws Cancelled.
inline constexpr double kSpacingAngstrom = 0.1;
std::vector<ChannelSample> centre_line(const Clearance& clearance, const Envelope& envelope,
                                       const LineStart& start, const RunContext& context);

// A line towards infinity ends only where its radius is at least this many times the bottleneck's.
// So the line visibly leaves its bottleneck.
inline constexpr double kEndOverBottleneck = 1.5;

// Makes the channel's samples from both parts of the curve, with their lengths along the line. The
// place of the cut stays where it is and becomes the sample `bottleneck`. A free end is cut off at
// the channel's end radius. Throws Cancelled.
void set_channel_line(const Clearance& clearance, const Envelope& envelope, const CutCurve& cut,
                      bool first_fixed, bool last_fixed, Channel& channel,
                      const RunContext& context);
// Adds the balls whose surfaces touch the sphere of the narrowest sample to `channel.touching`.
void set_touching(const Clearance& clearance, Channel& channel);

}  // namespace alphascope
