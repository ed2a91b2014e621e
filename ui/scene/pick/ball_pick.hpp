// Which ball the mouse is on: a ray through the balls as drawn. Pure geometry for display, in
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
  // Where the ray enters what is kept of it, in lengths of the ray's direction. At a plane of the
  // cut, a little before it, as its cap is drawn.
  double depth = 0;
};

// The first ball that the ray enters ahead of its start; `radii` as drawn, 0 = not drawn. Of the
// ray, only what is `kept` counts. Tries them all.
std::optional<BallHit> pick_ball(const BallGeometry& balls, const std::vector<float>& radii,
                                 const Ray& ray, const Stretch& kept = {});

// The same by boxes, which are made once a set of balls, for any radii.
class BallPicker {
 public:
  explicit BallPicker(std::shared_ptr<const BallGeometry> balls);

  // Å by which the boxes are too small for these radii; linear in their number, so once for all
  // rays.
  double margin(const std::vector<float>& radii) const;
  std::optional<BallHit> pick(const std::vector<float>& radii, double margin, const Ray& ray,
                              const Stretch& kept = {}) const;

 private:
  std::shared_ptr<const BallGeometry> balls_;
  BoxTree tree_;  // of the balls at their own radii
};

}  // namespace alphascope
