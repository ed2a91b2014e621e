// SPDX-License-Identifier: GPL-3.0-or-later
// Views from another side: their direction, and which way is up. Plain numbers; no VTK.
#pragma once

#include <array>

#include "core/geometry/real_point.hpp"
#include "ui/scene/camera.hpp"

namespace alphascope {

// The view of the same point from this side, at the same distance. `towards_viewer` is a unit
// vector. The upward direction stays as near as possible. `sight` is that of `view`.
Viewpoint view_from(Viewpoint view, const ViewFrustum& sight,
                    const std::array<double, 3>& towards_viewer);
// The same, but the views along axes of the file have upward directions of their own: y along the z
// axis, and z along the others.
Viewpoint view_of_side(const Viewpoint& view, const ViewFrustum& sight,
                       const std::array<double, 3>& towards_viewer);

// The direction towards the viewer of a view that is normal to this line (a unit vector). It is the
// view of the least turn, unless that looks steeply up or down because the line runs nearly along
// the line of sight. Then the view turns to the side, and what was up stays up.
std::array<double, 3> side_across(const ViewFrustum& sight, const RealPoint& line);

}  // namespace alphascope
