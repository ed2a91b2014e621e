// SPDX-License-Identifier: GPL-3.0-or-later
// The ball under the mouse: intersects a ray with the balls as drawn. Pure geometry for display, in
// floats.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/scene/cut.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/pick/box_tree.hpp"

namespace alphascope {

struct BallHit {
  std::size_t ball = 0;
  // Where the ray enters the kept part of the ball, in lengths of the ray's direction. At a plane
  // of the cut it is a little less, since caps are drawn in front of the plane.
  double depth = 0;
};

// The first ball that the ray enters ahead of its start. `radii` are those drawn (Å; 0: not drawn).
// Only the interval `kept` of the ray counts. Tries all balls one by one.
std::optional<BallHit> pick_ball(const BallGeometry& balls, const std::vector<float>& radii,
                                 const Ray& ray, const RayInterval& kept = {});

// Picks like pick_ball(), with boxes. The boxes are made once for a set of balls and serve for any
// radii.
class BallPicker {
 public:
  explicit BallPicker(std::shared_ptr<const BallGeometry> balls);

  // Å by which the boxes must grow for these radii. It takes time linear in the number of balls, so
  // it is computed once for all rays.
  double margin(const std::vector<float>& radii) const;
  std::optional<BallHit> pick(const std::vector<float>& radii, double margin, const Ray& ray,
                              const RayInterval& kept = {}) const;

 private:
  std::shared_ptr<const BallGeometry> balls_;
  BoxTree tree_;  // of the balls with their own radii
};

}  // namespace alphascope
