// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the three directions of one view into those of another about one axis.
#include "ui/scene/view_between.hpp"

#include <array>
#include <cmath>

#include "core/geometry/real_point.hpp"

namespace alphascope {
namespace {

RealPoint point(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

std::array<double, 3> coordinates(const RealPoint& p) {
  return {p.x, p.y, p.z};
}

// Right, up and forward, of length 1.
using Directions = std::array<RealPoint, 3>;

Directions directions(const Viewpoint& view) {
  const RealPoint forward = unit_vector(point(view.focal_point) - point(view.position));
  const RealPoint right = unit_vector(cross(forward, point(view.up)));
  return {right, cross(right, forward), forward};
}

double distance(const Viewpoint& view) {
  return length(point(view.focal_point) - point(view.position));
}

struct Turn {
  RealPoint axis;    // of length 1
  double angle = 0;  // radians, 0 to pi
};

// The turn that carries `from` into `to`.
Turn turn_between(const Directions& from, const Directions& to) {
  double trace = 0;
  RealPoint sine{};  // the axis times the sine of the angle
  for (std::size_t i = 0; i < 3; ++i) {
    trace += dot(from[i], to[i]);
    sine = sine + 0.5 * cross(from[i], to[i]);
  }
  const Turn turn{unit_vector(sine), std::atan2(length(sine), (trace - 1) / 2)};
  constexpr double kNearlyZero = 1e-7;
  if (length(sine) > kNearlyZero || trace > 0) return turn;
  // Half a turn: the sum of a vector and of the turned vector lies along the axis.
  RealPoint longest{};
  for (std::size_t i = 0; i < 3; ++i) {
    const RealPoint sum = from[i] + to[i];
    if (length(sum) > length(longest)) longest = sum;
  }
  return {unit_vector(longest), M_PI};
}

RealPoint turned(const RealPoint& v, const Turn& turn) {
  const double c = std::cos(turn.angle), s = std::sin(turn.angle);
  return c * v + s * cross(turn.axis, v) + ((1 - c) * dot(turn.axis, v)) * turn.axis;
}

}  // namespace

Viewpoint view_between(const Viewpoint& from, const Viewpoint& to, double share) {
  if (share <= 0) return from;
  if (share >= 1) return to;
  const Directions start = directions(from);
  Turn turn = turn_between(start, directions(to));
  turn.angle *= share;
  const RealPoint forward = turned(start[2], turn);
  const double far = distance(from) * std::pow(distance(to) / distance(from), share);
  const RealPoint middle =
      point(from.focal_point) + share * (point(to.focal_point) - point(from.focal_point));
  Viewpoint view;
  view.focal_point = coordinates(middle);
  view.position = coordinates(middle - far * forward);
  view.up = coordinates(turned(start[1], turn));
  view.least_aspect = from.least_aspect + share * (to.least_aspect - from.least_aspect);
  return view;
}

}  // namespace alphascope
