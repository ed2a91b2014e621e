// VTK's mapper for balls, with two faults mended: with perspective it cuts straight pieces off near
// balls, and it counts the centres as all that is drawn. For sources of the scene only.
#pragma once

#include <vtkOpenGLSphereMapper.h>
#include <vtkShader.h>

#include <map>

namespace alphascope {

class BallMapper : public vtkOpenGLSphereMapper {
 public:
  static BallMapper* New();
  vtkTypeMacro(BallMapper, vtkOpenGLSphereMapper);

 protected:
  BallMapper();
  ~BallMapper() override;
  void GetShaderTemplate(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                         vtkActor* actor) override;
  // Of the balls. VTK leaves out what it believes to be beside the picture.
  void ComputeBounds() override;

 private:
  BallMapper(const BallMapper&) = delete;
  void operator=(const BallMapper&) = delete;
};

}  // namespace alphascope
