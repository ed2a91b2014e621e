// SPDX-License-Identifier: GPL-3.0-or-later
// The display controls as options for scene and mesh. Window and command line both use these
// functions.
#pragma once

#include "core/document/settings/display.hpp"
#include "core/document/settings/request.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

SceneStyle scene_style(const DisplaySettings& display, Theme theme);
MeshOptions mesh_options(const DisplaySettings& display, Theme theme);
// Returns the meaning of a mesh's colours. If the mesh has the colours of its balls, this is
// `of_balls`. Empty if nothing is drawn or the colours have no meaning.
std::optional<ColourMeaning> mesh_colour_meaning(const ComplexMesh& mesh,
                                                 const MeshOptions& options,
                                                 const std::optional<ColourMeaning>& of_balls);
// `shown` is the request of the complex that grown balls belong to; null if there is no complex.
BallStyle ball_style(const DisplaySettings& display, const Request* shown);

}  // namespace alphascope
