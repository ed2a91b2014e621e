// SPDX-License-Identifier: GPL-3.0-or-later
// Computes views from another side.
#include "ui/scene/view_direction.hpp"

#include <cmath>

#include "core/document/settings/clip.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

// Cosine of the angle to the upward direction (26°) within which a view is one from above or below.
constexpr double kSteep = 0.9;

RealPoint point(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

Viewpoint view_from(Viewpoint view, const ViewFrustum& sight,
                    const std::array<double, 3>& towards_viewer) {
  const double along_up = dot(point(sight.up), point(towards_viewer));
  for (std::size_t k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] + sight.distance * towards_viewer[k];
    // From above, the former forward direction points up; from below, its opposite does.
    view.up[k] = along_up > kSteep    ? sight.forward[k]
                 : along_up < -kSteep ? -sight.forward[k]
                                      : sight.up[k];
  }
  return view;
}

Viewpoint view_of_side(const Viewpoint& view, const ViewFrustum& sight,
                       const std::array<double, 3>& towards_viewer) {
  Viewpoint of_side = view_from(view, sight, towards_viewer);
  if (axis_name(towards_viewer).empty()) return of_side;
  of_side.up = {0, 0, 1};
  if (towards_viewer[2] != 0) of_side.up = {0, 1, 0};
  return of_side;
}

std::array<double, 3> side_across(const ViewFrustum& sight, const RealPoint& line) {
  const auto part_across = [&line](const RealPoint& v) { return v - dot(v, line) * line; };
  RealPoint forward = part_across(point(sight.forward));
  const double turned = length(forward);
  const double along_up = turned > 0 ? dot(forward, point(sight.up)) / turned : 1;
  // The part of `right` across the line is not zero here, since the line is near the plane of
  // `forward` and `up`.
  if (turned < 0.01 || std::fabs(along_up) > kSteep) forward = part_across(point(sight.right));
  forward = unit_vector(forward);
  return {-forward.x, -forward.y, -forward.z};
}

}  // namespace alphascope
