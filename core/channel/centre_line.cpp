// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a curve to the middle of a channel. It is cut off at its ends and straightened; then its
// places rise to maxima of clearance.
#include "core/channel/centre_line.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/channel/walk.hpp"
#include "core/clearance/plane_ascent.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

using Line = std::vector<RealPoint>;

constexpr double kCoarseSpacing = 0.2;  // Å, while the line moves
// Å; less than kSpacingAngstrom, because the last ascent moves places apart a little
constexpr double kFineSpacing = 0.08;
// The tangent at a place is the direction between two other places of the line, kTangentReach (Å)
// before and after it. In wide parts the distance is the share kTangentShare of the clearance,
// because nearer places give no clear direction there.
constexpr double kTangentReach = 0.5, kTangentShare = 0.5;
constexpr int kRounds = 60;
constexpr double kStill = 0.004;  // Å: rounds end when no place moves farther

// While the line moves, spacing and moves are larger where it is wide, by this factor. Otherwise a
// line through a wide chamber does not settle in kRounds. Up to 8 Å the factor is 1.
double scale_at(double clearance) {
  constexpr double kBegin = 6, kDouble = 2, kMost = 4;
  return std::clamp((clearance - kBegin) / kDouble, 1.0, kMost);
}

double line_length(const Line& line) {
  double sum = 0;
  for (std::size_t n = 1; n < line.size(); ++n) sum += length(line[n] - line[n - 1]);
  return sum;
}

// Places along the line, at most `spacing` (Å) apart. Both ends stay. Distances are equal, or
// proportional to the scales of all places where these are given.
Line resampled(const Line& line, double spacing, const std::vector<double>& scales = {}) {
  std::vector<double> sizes;  // of each segment, Å
  double whole = 0;
  for (std::size_t n = 1; n < line.size(); ++n) {
    const double scale = scales.empty() ? 1 : (scales[n] + scales[n - 1]) / 2;
    sizes.push_back(length(line[n] - line[n - 1]) / scale);
    whole += sizes.back();
  }
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(whole / spacing)));
  Line result{line.front()};
  double passed = 0;
  std::size_t segment = 0;
  for (std::size_t n = 1; n < count; ++n) {
    const double at = whole * static_cast<double>(n) / static_cast<double>(count);
    while (passed + sizes[segment] < at && segment + 1 < sizes.size()) passed += sizes[segment++];
    const double share = sizes[segment] > 0 ? std::min(1.0, (at - passed) / sizes[segment]) : 0;
    result.push_back(line[segment] + share * (line[segment + 1] - line[segment]));
  }
  result.push_back(line.back());
  return result;
}

RealPoint tangent(double clearance, const Line& line, std::size_t n, double spacing) {
  const double angstrom = std::max(kTangentReach, kTangentShare * clearance);
  const auto reach = static_cast<std::size_t>(std::lround(angstrom / spacing));
  const std::size_t low = n > reach ? n - reach : 0, high = std::min(n + reach, line.size() - 1);
  return unit_vector(line[high] - line[low]);
}

// Cuts the wide start off a curve. Walks on while clearance is at least `radius`, and returns the
// rest. Clearance changes by no more than the distance walked, so wide parts take few steps.
Line cut_start(const Clearance& clearance, double radius, const Line& curve) {
  constexpr double kStep = 0.05;  // Å
  Walk walk(curve);
  Walk cut = walk;
  while (!walk.at_end()) {
    const double above = clearance.at(walk.place()) - radius;
    if (above < 0) break;
    cut = walk;
    walk.advance(std::max(above, kStep));
  }
  if (cut.at_end()) return curve;
  Line result{cut.place()};
  result.insert(result.end(), curve.begin() + static_cast<std::ptrdiff_t>(cut.segment()) + 1,
                curve.end());
  return result;
}

// Returns whether clearance is at least `radius` on the whole segment.
bool is_wide(const Clearance& clearance, const RealPoint& from, const RealPoint& to,
             double radius) {
  constexpr double kStep = 0.05;  // Å
  const double whole = length(to - from);
  const RealPoint along = unit_vector(to - from);
  for (double at = 0; at < whole;) {
    const double above = clearance.at(from + at * along) - radius;
    if (above < 0) return false;
    at += std::max(above, kStep);
  }
  return true;
}

// Replaces parts of the line by straight segments wherever these are wider than `radius`. In wide
// space, edges of the power diagram make long detours.
Line straightened(const Clearance& clearance, const Line& line, double radius,
                  const CancelToken& cancel) {
  Line result;
  for (std::size_t n = 0; n < line.size();) {
    cancel.throw_if_cancelled();
    result.push_back(line[n]);
    std::size_t next = n + 1;
    if (clearance.at(line[n]) >= radius) {
      for (std::size_t hop = std::bit_floor(line.size()); hop > 1; hop /= 2) {
        if (n + hop >= line.size() || !is_wide(clearance, line[n], line[n + hop], radius)) continue;
        next = n + hop;
        break;
      }
    }
    n = next;
  }
  return result;
}

// Repeats straightening as long as it shortens the line by more than 2 %.
Line taut(const Clearance& clearance, Line line, double radius, const CancelToken& cancel) {
  constexpr int kMostTimes = 12;
  constexpr double kWorth = 0.98;
  for (int n = 0; n < kMostTimes; ++n) {
    const double before = line_length(line);
    line = resampled(straightened(clearance, line, radius, cancel), kCoarseSpacing);
    if (line_length(line) > kWorth * before) break;
  }
  return line;
}

// Removes folds of the line. A segment replaces a fold if it is as wide as the fold's ends and less
// than half as long.
Line without_folds(const Clearance& clearance, const Line& line, const CancelToken& cancel) {
  constexpr double kLeastFold = 2, kNarrower = 0.02;  // Å
  Line result;
  for (std::size_t n = 0; n < line.size(); ++n) {
    cancel.throw_if_cancelled();
    result.push_back(line[n]);
    const double own = clearance.at(line[n]);
    double along = 0;
    std::size_t back = n;
    for (std::size_t k = n + 1; k < line.size(); ++k) {
      along += length(line[k] - line[k - 1]);
      if (along < kLeastFold || 2 * length(line[k] - line[n]) > along) continue;
      const double radius = std::min(own, clearance.at(line[k])) - kNarrower;
      if (is_wide(clearance, line[n], line[k], radius)) back = k;
    }
    if (back > n) n = back - 1;
  }
  return result;
}

// Adds places so that neighbours are at most kSpacingAngstrom apart.
Line filled(const Line& line) {
  Line result;
  for (const RealPoint& next : line) {
    if (!result.empty()) {
      const RealPoint last = result.back(), step = next - last;
      const auto parts = static_cast<int>(std::ceil(length(step) / kSpacingAngstrom));
      for (int part = 1; part < parts; ++part) {
        result.push_back(last + (static_cast<double>(part) / parts) * step);
      }
    }
    result.push_back(next);
  }
  return result;
}

// The inputs that stay the same while a line moves.
struct Scene {
  const Clearance& clearance;
  const Envelope& envelope;
  const LineStart& start;
  const CancelToken& cancel;

  bool is_wide(const RealPoint& x) const { return clearance.at(x) >= start.end_radius_angstrom; }
  bool stays(const Line& line, std::size_t n) const {
    if (n == 0 && start.first_fixed) return true;
    if (n + 1 == line.size() && start.last_fixed) return true;
    return !envelope.holds(line[n]) && is_wide(line[n]);
  }
};

// Shortens both free ends: while the second place from an end is still wide, the end's place is
// dropped.
void cut_ends(const Scene& scene, Line& line) {
  if (!scene.start.last_fixed) {
    while (line.size() > 2 && scene.is_wide(line[line.size() - 2])) line.pop_back();
  }
  if (!scene.start.first_fixed) {
    std::size_t drop = 0;
    while (line.size() - drop > 2 && scene.is_wide(line[drop + 1])) ++drop;
    line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(drop));
  }
}

// Moves each place to a maximum of clearance in the plane normal to the line. Fixed ends and places
// in the open stay. The limits are those at `spacing`; with `scales` both are scaled, and the
// scales at the new places are written there.
Line ascended(const Scene& scene, const Line& line, double spacing, const AscentLimits& limits,
              std::vector<double>* scales = nullptr) {
  Line result = line;
  if (scales != nullptr) scales->resize(line.size());
  constexpr std::size_t kTogether = 32;
  parallel_ranges(0, line.size(), kTogether, [&](std::size_t first, std::size_t last) {
    ClearanceNearby nearby(scene.clearance);
    // Returns the clearance at the new place.
    const auto ascend = [&](std::size_t n) {
      if (scene.stays(line, n)) return scene.clearance.at(line[n]);
      const double own = nearby.look_around(line[n], 2 * limits.longest_step_angstrom);
      const double scale = scales != nullptr ? scale_at(own) : 1;
      const RealPoint normal = tangent(own, line, n, scale * spacing);
      if (normal == RealPoint{}) return own;
      const Ascent ascent =
          ascend_in_plane(nearby, line[n], normal, limits.with_steps_scaled(scale));
      result[n] = ascent.place;
      return ascent.clearance_angstrom;
    };
    for (std::size_t n = first; n < last && !scene.cancel.cancelled(); ++n) {
      const double clearance = ascend(n);
      if (scales != nullptr) (*scales)[n] = scale_at(clearance);
    }
  });
  scene.cancel.throw_if_cancelled();
  return result;
}

Line smoothed(const Scene& scene, const Line& line) {
  Line result = line;
  for (std::size_t n = 1; n + 1 < line.size(); ++n) {
    if (!scene.stays(line, n)) result[n] = 0.25 * (line[n - 1] + 2 * line[n] + line[n + 1]);
  }
  return result;
}

// Returns whether no place of `line` is far from the line `before`.
bool is_settled(const Scene& scene, const Line& line, const Line& before) {
  std::size_t near = 0;
  for (const RealPoint& p : line) {
    // Both lines run the same way, so the search for the nearest place continues from the last one.
    while (near + 1 < before.size() && length(before[near + 1] - p) < length(before[near] - p)) {
      ++near;
    }
    double distance = length(before[near] - p);
    for (const std::size_t n : {near, near + 1}) {
      if (n == 0 || n >= before.size()) continue;
      const RealPoint along = before[n] - before[n - 1], from = p - before[n - 1];
      const double square = dot(along, along);
      const double share = square > 0 ? std::clamp(dot(from, along) / square, 0.0, 1.0) : 0;
      distance = std::min(distance, length(from - share * along));
    }
    if (distance < kStill) continue;
    if (distance >= kStill * scale_at(scene.clearance.at(p))) return false;
  }
  return true;
}

}  // namespace

CutCurve cut_at_least_clearance(const Clearance& clearance, const std::vector<RealPoint>& curve,
                                const CancelToken& cancel) {
  // Clearance changes by no more than the distance walked. So a step misses no place that is
  // narrower by more than half of the added length.
  constexpr double kCoarse = 0.05, kFine = 2 * kLeastClearanceError;
  double least = std::numeric_limits<double>::infinity();
  Walk best(curve);
  const auto look = [&](const Walk& walk) {
    cancel.throw_if_cancelled();
    const double here = clearance.at(walk.place());
    if (here < least) {
      least = here;
      best = walk;
    }
    return here;
  };
  // The corners of the curve come first, so that a good minimum is known early. A curve that begins
  // far away gets narrower from place to place; without a known minimum each step there would be
  // short.
  for (Walk walk(curve); !walk.at_end(); walk.advance_to_corner()) look(walk);
  for (const double added : {kCoarse, kFine}) {
    for (Walk walk(curve); !walk.at_end();) walk.advance(look(walk) - least + added);
  }
  if (clearance.at(curve.back()) < least) return {curve, {curve.back()}};
  const auto corner = curve.begin() + static_cast<std::ptrdiff_t>(best.segment()) + 1;
  CutCurve cut{{curve.begin(), corner}, {corner, curve.end()}};
  const RealPoint place = best.place();
  if (cut.before.back() != place) cut.before.push_back(place);
  cut.after.insert(cut.after.begin(), place);
  return cut;
}

std::vector<ChannelSample> centre_line(const Clearance& clearance, const Envelope& envelope,
                                       const LineStart& start, const RunContext& context) {
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  Line line = start.curve;
  if (!start.first_fixed) line = cut_start(clearance, start.end_radius_angstrom, line);
  if (!start.last_fixed) {
    std::reverse(line.begin(), line.end());
    line = cut_start(clearance, start.end_radius_angstrom, line);
    std::reverse(line.begin(), line.end());
  }
  line =
      taut(clearance, resampled(line, kCoarseSpacing), start.end_radius_angstrom, context.cancel);
  // A curve along edges of the power diagram is jagged. Small steps and smoothing in turn keep the
  // places in order while they move.
  const Scene scene{clearance, envelope, start, context.cancel};
  const AscentLimits in_rounds{0.15, 0.03, kAnywhere, 0.15};
  // At the rim of a molecule there may be no middle to move to around a fixed end. The line would
  // then go back and forth between that end and the open, farther in each round. A line that gets
  // this much longer (plus 1 Å) is therefore undone.
  constexpr double kMostLonger = 1.25;
  const double most = kMostLonger * line_length(line) + 1;
  std::vector<double> scales;  // of all places in a round
  for (int round = 0; round < kRounds; ++round) {
    context.report(kCentreLineStage, static_cast<double>(round) / kRounds);
    const Line before = line;
    line = ascended(scene, smoothed(scene, line), kCoarseSpacing, in_rounds, &scales);
    line = resampled(line, kCoarseSpacing, scales);
    cut_ends(scene, line);
    if (line_length(line) > most) {
      line = before;
      break;
    }
    if (is_settled(scene, line, before)) break;
  }
  line = resampled(without_folds(clearance, line, context.cancel), kFineSpacing);
  line = ascended(scene, line, kFineSpacing, {0.1, 1e-7, kAnywhere, 0.4});
  line = filled(line);
  std::vector<ChannelSample> samples;
  samples.reserve(line.size());
  for (const RealPoint& place : line) samples.push_back({place, clearance.at(place), 0});
  return samples;
}

void set_channel_line(const Clearance& clearance, const Envelope& envelope, const CutCurve& cut,
                      bool first_fixed, bool last_fixed, Channel& channel,
                      const RunContext& context) {
  LineStart start;
  start.end_radius_angstrom = channel.end_radius_angstrom;
  start.first_fixed = first_fixed;
  if (cut.before.size() > 1) {
    start.curve = cut.before;
    channel.samples = centre_line(clearance, envelope, start, context);
    channel.samples.pop_back();
  }
  channel.bottleneck = channel.samples.size();
  start.first_fixed = true;
  start.last_fixed = last_fixed;
  start.curve = cut.after;
  const std::vector<ChannelSample> after = centre_line(clearance, envelope, start, context);
  channel.samples.insert(channel.samples.end(), after.begin(), after.end());
  for (std::size_t n = 1; n < channel.samples.size(); ++n) {
    ChannelSample& sample = channel.samples[n];
    const ChannelSample& last = channel.samples[n - 1];
    sample.along_angstrom =
        last.along_angstrom + length(sample.position_angstrom - last.position_angstrom);
  }
  channel.length_angstrom = channel.samples.back().along_angstrom;
}

void set_touching(const Clearance& clearance, Channel& channel) {
  constexpr double kTouching = 0.01;  // Å
  std::vector<Surface> surfaces;
  const ChannelSample& place = channel.narrowest();
  clearance.collect(place.position_angstrom, place.radius_angstrom + kTouching, surfaces);
  for (const Surface& surface : surfaces) channel.touching.push_back(surface.ball);
}

}  // namespace alphascope
