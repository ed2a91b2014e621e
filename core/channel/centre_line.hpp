// The line through the middle of a channel: a curve outside all balls is moved up to where, in the
// planes normal to it, clearance has local maxima.
#pragma once

#include <string_view>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/channel/clearance.hpp"
#include "core/channel/envelope.hpp"

namespace alphascope {

// What RunContext::progress is told while the line moves.
inline constexpr std::string_view kCentreLineStage = "centre line";

struct LineStart {
  std::vector<RealPoint> curve;  // Å; two places or more
  // Whether an end stays where it is. One that does not is cut off where clearance reaches
  // `end_radius_angstrom` for the last time.
  bool first_fixed = true, last_fixed = true;
  double end_radius_angstrom = 5;
};

// A place on a curve, cut in two there: nowhere on it is clearance less by more than this (Å).
inline constexpr double kLeastClearanceError = 2.5e-4;
struct CutCurve {
  std::vector<RealPoint> before, after;  // the place is the last of one and the first of the other
};
CutCurve cut_at_least_clearance(const Clearance& clearance, const std::vector<RealPoint>& curve,
                                const CancelToken& cancel);

// What is wider than the end radius and outside the envelope has no middle, and stays where it is.
// Positions and radii, at most `kSpacingAngstrom` apart; no lengths. Works in the caller's task
// arena; does not depend on the number of threads. Throws Cancelled.
inline constexpr double kSpacingAngstrom = 0.1;
std::vector<ChannelSample> centre_line(const Clearance& clearance, const Envelope& envelope,
                                       const LineStart& start, const RunContext& context);

// A line that ends towards infinity has to get out of its bottleneck to show it: its end radius is
// at least so many times the bottleneck's.
inline constexpr double kEndOverBottleneck = 1.5;

// The lines of both parts of the curve as the channel's samples, with their lengths: the place of
// the cut stays, and is the sample `bottleneck`. Cut off at the channel's end radius where an end
// is not fixed. Throws Cancelled.
void set_channel_line(const Clearance& clearance, const Envelope& envelope, const CutCurve& cut,
                      bool first_fixed, bool last_fixed, Channel& channel,
                      const RunContext& context);
// The balls whose surfaces touch the narrowest sample.
void set_touching(const Clearance& clearance, Channel& channel);

}  // namespace alphascope
