// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry of a view as plain numbers: its angles, the distance that shows all balls, and whether
// it shows anything. No VTK.
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

// Position and direction of the camera (Å, relative to BallGeometry::origin).
struct Viewpoint {
  std::array<double, 3> position{0, 0, 1}, focal_point{}, up{0, 1, 0};
  // Width over height of the narrowest picture that shows this view at the usual angle. A narrower
  // picture gets a larger angle, so that its sides are not cut off. 0: any width will do.
  double least_aspect = 0;
  friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

// The pyramid that a picture shows: its apex, unit vectors, and tangents of half its angles.
// Without perspective it is a box, as wide as the pyramid is at the focal point.
struct ViewFrustum {
  std::array<double, 3> position{}, forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
  double tangent_right = 1, tangent_up = 1;
  double distance = 1;  // Å, to the focal point
  bool orthographic = false;

  // Returns the length, Å, that the tangents multiply to half the width and height of the view.
  // `ahead`: distance before the camera, Å.
  double depth_of_width(double ahead) const { return orthographic ? distance : ahead; }
};

// The line of sight through a point of the picture. Coordinates run from -1 (left, bottom) to 1.
Ray ray_through(const ViewFrustum& sight, double across, double upwards);
// Returns the width of a pixel, Å, at the end of the ray's direction vector. `height` of the
// picture is in pixels.
double pixel_spread(const ViewFrustum& sight, int height);

// Where a picture of this size shows a point: pixels from its top left. The point may lie outside
// the picture. Empty if the point is not in front of the viewer.
std::optional<std::array<double, 2>> project_point(const ViewFrustum& sight,
                                                   const std::array<double, 3>& point, int width,
                                                   int height);

// Tangent of half the angle from the bottom to the top of a picture of this aspect.
double tangent_up(double aspect, double least_aspect);

// Distance (Å) of the camera from the origin, along axes[2]. From there the outline of the balls
// just fits, with a small margin. `drawn` are the radii of the balls as drawn (Å); empty if they
// are not drawn. For each ball the larger of both radii counts.
double fitting_distance(const BallGeometry& balls, std::span<const float> drawn, double aspect);

// Viewpoint from which these balls fill most of the picture, with the direction and angles of
// `sight`.
Viewpoint viewpoint_for_balls(const BallGeometry& balls, const std::vector<BallIndex>& some,
                              const ViewFrustum& sight);

// Viewpoint::least_aspect for the part of the balls that a picture of `aspect` shows.
double least_aspect(const BallGeometry& balls, const ViewFrustum& sight, double aspect);

// `radii` are those of the balls as drawn (Å); empty if they are not drawn. `complex` tells whether
// simplices are drawn too, which may be in view without any ball. With a complex, a view counts as
// empty only if it surely shows no simplex.
ViewProblem view_problem(const BallGeometry& balls, const std::vector<float>& radii,
                         const ViewFrustum& sight, bool complex);

}  // namespace alphascope
