// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's mapper for balls, with two faults mended. With perspective VTK's triangle cuts off parts of
// near balls, and VTK's bounds contain only the centres. For sources of the scene only.
#pragma once

#include <vtkOpenGLSphereMapper.h>
#include <vtkShader.h>

#include <cstdint>
#include <map>

namespace alphascope {

// usual: nearer things hide balls, as they hide everything else.
// outline: only the rims of balls are drawn, around other things.
// in_front: whole balls in front of everything else, with a dark rim.
enum class BallRendering : std::uint8_t { usual, outline, in_front };

class BallMapper : public vtkOpenGLSphereMapper {
 public:
  static BallMapper* New();
  vtkTypeMacro(BallMapper, vtkOpenGLSphereMapper);

  void set_look(BallRendering look);

 protected:
  BallMapper();
  ~BallMapper() override;
  void GetShaderTemplate(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                         vtkActor* actor) override;
  // The bounds of whole balls. VTK does not draw a mapper whose bounds are outside the picture.
  void ComputeBounds() override;

 private:
  BallRendering look_ = BallRendering::usual;

  BallMapper(const BallMapper&) = delete;
  void operator=(const BallMapper&) = delete;
};

}  // namespace alphascope
