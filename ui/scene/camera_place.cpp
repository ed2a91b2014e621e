// SPDX-License-Identifier: GPL-3.0-or-later
// Converts viewpoints to the camera of session files and back.
#include "ui/scene/camera_place.hpp"

namespace alphascope {

CameraPlace camera_place(const Viewpoint& v, const BallGeometry& balls) {
  return {balls.origin, v.position, v.focal_point, v.up, v.least_aspect};
}

Viewpoint viewpoint_at(const CameraPlace& camera, const BallGeometry& balls) {
  Viewpoint v{camera.position, camera.target, camera.up, camera.least_aspect};
  for (std::size_t k = 0; k < 3; ++k) {
    const double moved = camera.origin[k] - balls.origin[k];  // 0 between the same balls
    v.position[k] += moved;
    v.focal_point[k] += moved;
  }
  return v;
}

}  // namespace alphascope
