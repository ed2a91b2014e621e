// SPDX-License-Identifier: GPL-3.0-or-later
// Viewpoints as session files keep them.
#pragma once

#include "core/document/session/session_file.hpp"
#include "ui/scene/camera.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

CameraPlace camera_place(const Viewpoint& viewpoint, const BallGeometry& balls);
// With the same balls the result is the viewpoint that was saved, bit for bit.
Viewpoint viewpoint_at(const CameraPlace& camera, const BallGeometry& balls);

}  // namespace alphascope
