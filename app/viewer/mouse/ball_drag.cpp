// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a held ball of the sandbox: intersections of lines of sight with the plane of the drag.
#include "app/viewer/mouse/ball_drag.hpp"

#include <cmath>

namespace alphascope {
namespace {

// Least sine of the angle between line of sight and plane. At smaller angles, a small movement of
// the mouse would move the ball very far.
constexpr double kLeastSine = 0.05;

double dot(const SandboxPlace& a, const SandboxPlace& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
SandboxPlace difference(const SandboxPlace& a, const SandboxPlace& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

std::optional<BallDrag> BallDrag::begin(const Sandbox& sandbox, std::size_t ball, const Ray& ray,
                                        const SandboxPlace& into_view) {
  BallDrag drag;
  drag.ball_ = ball;
  drag.in_plane_ = centre_of(sandbox, ball);
  drag.normal_ = sandbox.flat ? SandboxPlace{0, 0, 1} : into_view;
  const auto at = drag.meet(ray);
  if (!at) return std::nullopt;
  drag.grip_ = difference(drag.in_plane_, *at);
  return drag;
}

std::optional<SandboxPlace> BallDrag::place(const Ray& ray) const {
  const auto at = meet(ray);
  if (!at) return std::nullopt;
  return SandboxPlace{(*at)[0] + grip_[0], (*at)[1] + grip_[1], (*at)[2] + grip_[2]};
}

std::optional<SandboxPlace> BallDrag::meet(const Ray& ray) const {
  const double along = dot(ray.direction, normal_);
  if (std::fabs(along) < kLeastSine * std::sqrt(dot(ray.direction, ray.direction))) return {};
  const double depth = dot(difference(in_plane_, ray.start), normal_) / along;
  if (!(depth > 0)) return {};
  SandboxPlace at = ray.start;
  for (std::size_t k = 0; k < 3; ++k) at[k] += depth * ray.direction[k];
  return at;
}

}  // namespace alphascope
