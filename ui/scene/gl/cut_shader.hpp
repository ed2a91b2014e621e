// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's shaders for a cut scene. Faces and lines end at the planes. Cut balls show a flat disc
// where the ray meets a plane inside them. For sources of the scene only.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <array>

#include "ui/scene/cut.hpp"

namespace alphascope {

// These functions turn cutting of an actor on or off. They change shaders, which are then compiled
// anew, only if necessary.
void cut_mesh_actor(vtkActor* actor, bool cut);
void cut_ball_actor(vtkActor* actor, bool cut);
// Rods of CellMapper. They end in flat caps, as balls do.
void cut_rod_actor(vtkActor* actor, bool cut);
// A closed surface whose triangles are counterclockwise from outside. Where the cut opens it, its
// inner side is drawn flat, in the surface's colour, so that it looks filled.
void cut_closed_actor(vtkActor* actor, bool cut);

// Both cutting planes as uniforms; a second plane that does not exist keeps everything. Camera and
// size (pixels) must be those of the next picture.
class CutPlanes {
 public:
  CutPlanes(const Cut& cut, vtkRenderer* renderer, int width, int height);
  void give_to(vtkActor* actor) const;          // a mesh, or a closed surface
  void give_to_rounded(vtkActor* actor) const;  // balls, or rods

 private:
  using Plane = std::array<float, 4>;
  static void give(vtkActor* actor, const std::array<Plane, 2>& planes);
  // A plane keeps points with plane · (x, y, z, 1) >= 0. camera_: in the camera's coordinates, Å.
  // fragment_: in the coordinates of fragments, pixels and depth from 0 to 1.
  std::array<Plane, 2> camera_, fragment_;
};

}  // namespace alphascope
