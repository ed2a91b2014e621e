// VTK's mapper for balls, with two faults mended: with perspective it cuts straight pieces off near
// balls, and it counts the centres as all that is drawn. For sources of the scene only.
#pragma once

#include <vtkOpenGLSphereMapper.h>
#include <vtkShader.h>

#include <cstdint>
#include <map>

namespace alphascope {

// What is seen of balls: all that is before the rest; only their rims, as outlines of what they
// are around; or all, before everything else in the picture and with a dark rim.
enum class BallLook : std::uint8_t { usual, outline, in_front };

class BallMapper : public vtkOpenGLSphereMapper {
 public:
  static BallMapper* New();
  vtkTypeMacro(BallMapper, vtkOpenGLSphereMapper);

  void set_look(BallLook look);

 protected:
  BallMapper();
  ~BallMapper() override;
  void GetShaderTemplate(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                         vtkActor* actor) override;
  // Of the balls. VTK leaves out what it believes to be beside the picture.
  void ComputeBounds() override;

 private:
  BallLook look_ = BallLook::usual;

  BallMapper(const BallMapper&) = delete;
  void operator=(const BallMapper&) = delete;
};

}  // namespace alphascope
