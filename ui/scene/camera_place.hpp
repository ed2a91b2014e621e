// A viewpoint as session files keep it, and back.
#pragma once

#include "core/document/session/session_file.hpp"
#include "ui/scene/camera.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

CameraPlace camera_place(const Viewpoint& viewpoint, const BallGeometry& balls);
// The same, bit for bit, between the same balls.
Viewpoint viewpoint_at(const CameraPlace& camera, const BallGeometry& balls);

}  // namespace alphascope
