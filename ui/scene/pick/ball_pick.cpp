// SPDX-License-Identifier: GPL-3.0-or-later
// Intersections of a ray with balls, tried one by one or by boxes.
#include "ui/scene/pick/ball_pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alphascope {
namespace {

// Where the ray enters the kept part of a ball, ahead of the ray's start; infinity: it does not.
double entry(const std::array<float, 3>& centre, float radius, const Ray& ray,
             const RayInterval& kept) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const auto& d = ray.direction;
  const double length2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  double along = 0, distance2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double to_centre = centre[k] - ray.start[k];
    along += to_centre * d[k];
    distance2 += to_centre * to_centre;
  }
  // The ray enters at the smaller t with |start + t d - centre|² = r².
  const double root2 = along * along - length2 * (distance2 - double{radius} * radius);
  if (radius <= 0 || !(length2 > 0) || root2 < 0) return kNowhere;
  const double root = std::sqrt(root2);
  const double enter = (along - root) / length2, leave = (along + root) / length2;
  if (enter > kept.to || leave < kept.from) return kNowhere;
  const bool capped = kept.from > 0 && enter < kept.from;
  if (!capped) return enter >= 0 ? enter : kNowhere;
  // |start + t d - centre|² - r² = length2 (t - enter) (t - leave).
  const double power = length2 * (kept.from - enter) * (leave - kept.from);
  return kept.from - (kLeastCapLift + kCapLift * power) / std::sqrt(length2);
}

// The nearest ball found so far. At equal depth the first in the list wins, so the result does not
// depend on the order of visits.
struct Nearest {
  BallHit hit{0, std::numeric_limits<double>::infinity()};

  void try_ball(std::size_t ball, double depth) {
    if (depth < hit.depth || (depth == hit.depth && ball < hit.ball)) hit = {ball, depth};
  }
  std::optional<BallHit> found() const {
    return std::isfinite(hit.depth) ? std::optional(hit) : std::nullopt;
  }
};

}  // namespace

std::optional<BallHit> pick_ball(const BallGeometry& balls, const std::vector<float>& radii,
                                 const Ray& ray, const RayInterval& kept) {
  if (radii.size() != balls.centres.size()) return std::nullopt;
  Nearest nearest;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    nearest.try_ball(i, entry(balls.centres[i], radii[i], ray, kept));
  }
  return nearest.found();
}

BallPicker::BallPicker(std::shared_ptr<const BallGeometry> balls)
    : balls_(std::move(balls)), tree_(balls_->centres.size(), [this](std::size_t i) {
        const auto& c = balls_->centres[i];
        const float r = balls_->radii[i];
        return Box{{c[0] - r, c[1] - r, c[2] - r}, {c[0] + r, c[1] + r, c[2] + r}};
      }) {}

double BallPicker::margin(const std::vector<float>& radii) const {
  // Coordinates of boxes are rounded. 0.01 Å is far more than the rounding in any molecule.
  constexpr double kRounding = 1e-2;
  double margin = 0;
  const std::size_t count = std::min(radii.size(), balls_->radii.size());
  for (std::size_t i = 0; i < count; ++i) {
    margin = std::max(margin, double{radii[i]} - balls_->radii[i]);
  }
  return margin + kRounding;
}

std::optional<BallHit> BallPicker::pick(const std::vector<float>& radii, double margin,
                                        const Ray& ray, const RayInterval& kept) const {
  if (radii.size() != tree_.size()) return std::nullopt;
  Nearest nearest;
  tree_.visit(
      [&](const Box& box) { return meets(ray, box, margin, nearest.hit.depth); },
      [&](std::size_t i) { nearest.try_ball(i, entry(balls_->centres[i], radii[i], ray, kept)); });
  return nearest.found();
}

}  // namespace alphascope
