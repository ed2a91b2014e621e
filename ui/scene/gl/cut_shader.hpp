// What VTK's shaders draw of a cut scene: faces and lines end at the planes, and cut balls show a
// flat disc where the ray meets a plane inside them. For sources of the scene only.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <array>

#include "ui/scene/cut.hpp"

namespace alphascope {

// Changes the shaders when that differs from what they do; then they are compiled anew.
void cut_mesh_actor(vtkActor* actor, bool cut);
void cut_ball_actor(vtkActor* actor, bool cut);

// Both planes for this camera, also where a cut has only one. The camera and the size of the
// picture must be those of the next picture.
class CutPlanes {
 public:
  CutPlanes(const Cut& cut, vtkRenderer* renderer, int width, int height);
  void give_to(vtkActor* actor) const;

 private:
  using Plane = std::array<float, 4>;
  // plane · (x, y, z, 1) >= 0 is kept. In the camera's coordinates; and of fragments, as their
  // shader knows them: pixels, and depth from 0 to 1.
  std::array<Plane, 2> camera_, fragment_;
};

}  // namespace alphascope
