// SPDX-License-Identifier: GPL-3.0-or-later
// Views between two views, for a camera that glides. No VTK.
#pragma once

#include "ui/scene/camera.hpp"

namespace alphascope {

// The view after this share of the way, from 0 to 1: turned about one axis, with the focal point on
// a line, and the distance multiplied by equal factors in equal steps. The ends are the views
// themselves.
Viewpoint view_between(const Viewpoint& from, const Viewpoint& to, double share);

}  // namespace alphascope
