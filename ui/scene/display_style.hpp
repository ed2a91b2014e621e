// What the display controls mean to scene and mesh: one place for the window and the command line.
#pragma once

#include "core/document/settings/display.hpp"
#include "core/document/settings/request.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

SceneStyle scene_style(const DisplayControls& display, Theme theme);
MeshOptions mesh_options(const DisplayControls& display, Theme theme);
// What the colours of a mesh of these options mean, those of balls where it has these; none: they
// mean nothing, or nothing is drawn.
std::optional<PaintKey> mesh_key(const ComplexMesh& mesh, const MeshOptions& options,
                                 const std::optional<PaintKey>& of_balls);
// `shown`: of the complex that grown balls belong to; null: there is none.
BallStyle ball_style(const DisplayControls& display, const Request* shown);

}  // namespace alphascope
