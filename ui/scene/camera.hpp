// What a view sees, as plain numbers: its angles, the distance that shows all balls, and whether it
// shows anything. No VTK.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/pick/box_tree.hpp"
#include "ui/view_problem.hpp"

namespace alphascope {

// Where the camera stands (Å, relative to BallGeometry::origin).
struct Viewpoint {
  std::array<double, 3> position{0, 0, 1}, focal_point{}, up{0, 1, 0};
  // Width over height of the narrowest picture that shows at the usual angle all that this view
  // should show. A narrower picture takes a larger angle instead of cutting off its sides.
  double least_aspect = 0;
};

// The pyramid that a picture shows: unit vectors from its apex, and the tangents of half its
// angles. Without perspective, the box that is as wide as the pyramid at the focal point.
struct Sight {
  std::array<double, 3> position{}, forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
  double tangent_right = 1, tangent_up = 1;
  double distance = 1;  // Å, to the focal point
  bool orthographic = false;

  // Half the width and height of what is seen so far ahead are the tangents times this (Å).
  double depth_of_width(double ahead) const { return orthographic ? distance : ahead; }
};

// The line of sight through a place of the picture, from -1 (left, bottom) to 1.
Ray ray_through(const Sight& sight, double across, double upwards);
// Å that a pixel of a picture of this height spans, for each length of such a ray's direction.
double pixel_spread(const Sight& sight, int height);

// Where a picture of this size (pixels) shows a point: pixels from its top left, also beside it.
// Nothing: the point is not ahead of the viewer.
std::optional<std::array<double, 2>> seen_at(const Sight& sight, const std::array<double, 3>& point,
                                             int width, int height);

// Tangent of half the angle from the bottom to the top of a picture of this aspect.
double tangent_up(double aspect, double least_aspect);

// From here, looking along -axes[2], the outline of the balls just fits, with a small margin.
// `drawn` are the radii that they are drawn with, Å, none: they are not drawn; the larger one of
// each counts.
double fitting_distance(const BallGeometry& balls, std::span<const float> drawn, double aspect);

// From where these balls fill most of the picture, in the direction and with the angles of `sight`.
Viewpoint looking_at(const BallGeometry& balls, const std::vector<BallIndex>& some,
                     const Sight& sight);

// Viewpoint::least_aspect for the part of the balls that a picture of `aspect` shows.
double least_aspect(const BallGeometry& balls, const Sight& sight, double aspect);

// `radii`: Å, as drawn; empty when balls are not drawn. `complex`: simplices are drawn, too. They
// can be in view when no ball is; then only what surely sees none of them is a problem.
ViewProblem view_problem(const BallGeometry& balls, const std::vector<float>& radii,
                         const Sight& sight, bool complex);

}  // namespace alphascope
