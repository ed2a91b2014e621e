// Which ball the mouse is on: a ray through the balls as drawn. Pure geometry for display, in
// floats.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/scene/ball_geometry.hpp"

namespace alphascope {

// Å, relative to BallGeometry::origin; the direction need not have unit length.
struct Ray {
  std::array<double, 3> start{};
  std::array<double, 3> direction{0, 0, -1};
};

// The first ball that the ray enters ahead of its start; `radii` as drawn, 0 = not drawn.
std::optional<std::size_t> pick_ball(const BallGeometry& balls, const std::vector<float>& radii,
                                     const Ray& ray);

}  // namespace alphascope
