// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of sight, places of points in a picture, and distances at which balls fit into it. Also the
// test for a view that shows nothing.
#include "ui/scene/camera.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

constexpr double kViewAngleDegrees = 25;  // less than VTK's 30: molecules distort less
constexpr double kMargin = 1.08;
using Vector = std::array<double, 3>;
// Without perspective, lines of sight begin this far behind the camera. So nothing lies behind
// their start, and a pixel is almost equally wide all along them.
constexpr double kFarBehind = 1e6;  // Å

double usual_tangent() {
  return std::tan(kViewAngleDegrees * M_PI / 360);
}

// Coordinates of a point in the viewer's directions: right, up, forward (Å from the camera).
template <class Point>
Vector seen_from(const ViewFrustum& sight, const Point& point) {
  Vector seen{};
  for (int k = 0; k < 3; ++k) {
    const double offset = point[k] - sight.position[k];
    seen[0] += offset * sight.right[k];
    seen[1] += offset * sight.up[k];
    seen[2] += offset * sight.forward[k];
  }
  return seen;
}

// Returns how far a ball is outside each side of the view, Å: left, right, bottom, top, behind. A
// number is negative if part of the ball is inside that side.
std::array<double, 5> outside_of(const ViewFrustum& sight, const Vector& seen, double radius) {
  const double across = std::hypot(1.0, sight.tangent_right);
  const double upwards = std::hypot(1.0, sight.tangent_up);
  const double depth = sight.depth_of_width(seen[2]);
  const double right = depth * sight.tangent_right, up = depth * sight.tangent_up;
  if (sight.orthographic) {
    return {-seen[0] - right - radius, seen[0] - right - radius, -seen[1] - up - radius,
            seen[1] - up - radius, -1};
  }
  return {(-seen[0] - right) / across - radius, (seen[0] - right) / across - radius,
          (-seen[1] - up) / upwards - radius, (seen[1] - up) / upwards - radius, -seen[2] - radius};
}

// Whether the eye is in the box around the balls as they are drawn.
bool is_near(const BallGeometry& balls, const std::vector<float>& radii, const ViewFrustum& sight) {
  const double reach = *std::max_element(radii.begin(), radii.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const double eye = sight.position[k];
    if (eye < balls.bounds[2 * k] - reach || eye > balls.bounds[2 * k + 1] + reach) return false;
  }
  return true;
}

}  // namespace

Ray ray_through(const ViewFrustum& sight, double across, double upwards) {
  const double right = across * sight.tangent_right, up = upwards * sight.tangent_up;
  Ray ray;
  for (std::size_t k = 0; k < 3; ++k) {
    const double aside = right * sight.right[k] + up * sight.up[k];
    ray.start[k] = sight.position[k];
    ray.direction[k] = sight.forward[k];
    if (sight.orthographic) {
      ray.start[k] += sight.distance * aside - kFarBehind * sight.forward[k];
    } else {
      ray.direction[k] += aside;
    }
  }
  return ray;
}

double pixel_spread(const ViewFrustum& sight, int height) {
  const double spread = 2 * sight.tangent_up / height;
  return sight.orthographic ? spread * sight.distance / kFarBehind : spread;
}

std::optional<std::array<double, 2>> project_point(const ViewFrustum& sight, const Vector& point,
                                                   int width, int height) {
  const Vector seen = seen_from(sight, point);
  const double depth = sight.depth_of_width(seen[2]);
  if (!(depth > 0)) return std::nullopt;
  return std::array<double, 2>{(1 + seen[0] / (depth * sight.tangent_right)) / 2 * width,
                               (1 - seen[1] / (depth * sight.tangent_up)) / 2 * height};
}

double tangent_up(double aspect, double least_aspect) {
  return usual_tangent() * std::max(1.0, aspect > 0 ? least_aspect / aspect : 1.0);
}

double fitting_distance(const BallGeometry& balls, std::span<const float> drawn, double aspect) {
  const double up = usual_tangent(), right = up * aspect;
  double distance = 1;
  for (std::size_t i = 0; i < balls.centres.size(); ++i) {
    double along[3] = {0, 0, 0};
    for (int a = 0; a < 3; ++a) {
      for (int k = 0; k < 3; ++k) along[a] += balls.axes[a][k] * balls.centres[i][k];
    }
    const double radius = std::max(balls.radii[i], drawn.empty() ? 0.0f : drawn[i]);
    const double reach =
        std::max((std::fabs(along[0]) + radius) / right, (std::fabs(along[1]) + radius) / up);
    distance = std::max(distance, reach + along[2]);
  }
  return kMargin * distance;
}

Viewpoint viewpoint_for_balls(const BallGeometry& balls, const std::vector<BallIndex>& some,
                              const ViewFrustum& sight) {
  constexpr double kSurroundings = 4;  // Å around each ball, so the picture of one atom shows its
                                       // neighbours
  Viewpoint view;
  view.up = sight.up;
  std::array<double, 6> box{1e30, -1e30, 1e30, -1e30, 1e30, -1e30};
  for (const BallIndex i : some) {
    for (int k = 0; k < 3; ++k) {
      const double c = balls.centres.at(i)[k];
      box[2 * k] = std::min(box[2 * k], c);
      box[2 * k + 1] = std::max(box[2 * k + 1], c);
    }
  }
  double radius = 0;
  for (int k = 0; k < 3; ++k) view.focal_point[k] = 0.5 * (box[2 * k] + box[2 * k + 1]);
  for (const BallIndex i : some) {
    double offset[3];
    for (int k = 0; k < 3; ++k) offset[k] = balls.centres[i][k] - view.focal_point[k];
    const double distance = std::hypot(offset[0], offset[1], offset[2]);
    radius = std::max(radius, distance + balls.radii[i] + kSurroundings);
  }
  const double tangent = std::min(sight.tangent_up, sight.tangent_right);
  const double distance = radius * std::hypot(1.0, tangent) / tangent;
  for (int k = 0; k < 3; ++k) {
    view.position[k] = view.focal_point[k] - distance * sight.forward[k];
  }
  return view;
}

double least_aspect(const BallGeometry& balls, const ViewFrustum& sight, double aspect) {
  double widest = 0;
  for (std::size_t i = 0; i < balls.centres.size(); ++i) {
    const Vector seen = seen_from(sight, balls.centres[i]);
    const double depth = sight.depth_of_width(seen[2]);
    if (depth <= 0) return aspect;  // the camera is among the balls
    widest = std::max(widest, (std::fabs(seen[0]) + balls.radii[i]) / depth);
  }
  return std::min(aspect, 1.02 * widest / usual_tangent());
}

ViewProblem view_problem(const BallGeometry& balls, const std::vector<float>& radii,
                         const ViewFrustum& sight, bool complex) {
  if (balls.centres.empty()) return ViewProblem::none;  // there is nothing that a view could show
  const bool drawn = radii.size() == balls.centres.size();
  // A camera outside the box of all balls is inside no ball. The loop may then end early.
  const bool may_be_inside = drawn && !sight.orthographic && is_near(balls, radii, sight);
  bool any_in_view = false;
  std::array<bool, 5> all_outside{true, true, true, true, true};
  for (std::size_t i = 0; i < balls.centres.size(); ++i) {
    const Vector seen = seen_from(sight, balls.centres[i]);
    const double radius = drawn ? radii[i] : 0;
    const bool inside = std::hypot(seen[0], seen[1], seen[2]) < radius;
    if (inside && !sight.orthographic) return ViewProblem::inside_a_ball;
    bool outside = drawn && radius <= 0;  // an empty ball is not drawn
    const auto sides = outside_of(sight, seen, radius);
    for (std::size_t s = 0; s < sides.size(); ++s) {
      outside = outside || sides[s] > 0;
      all_outside[s] = all_outside[s] && sides[s] > 0;
    }
    any_in_view = any_in_view || !outside;
    const bool seen_enough = complex ? std::none_of(all_outside.begin(), all_outside.end(),
                                                    [](bool beyond) { return beyond; })
                                     : any_in_view || !drawn;
    if (seen_enough && !may_be_inside) return ViewProblem::none;
  }
  // If all centres lie beyond one side of the view, all simplices do as well.
  const bool all_beyond_a_side =
      std::any_of(all_outside.begin(), all_outside.end(), [](bool b) { return b; });
  const bool nothing = complex ? all_beyond_a_side : drawn && !any_in_view;
  return nothing ? ViewProblem::nothing_in_view : ViewProblem::none;
}

}  // namespace alphascope
