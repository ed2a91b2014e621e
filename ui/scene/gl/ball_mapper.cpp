// SPDX-License-Identifier: GPL-3.0-or-later
// Changes VTK's sphere shaders for each BallRendering, and makes the bounds include the radii.
#include "ui/scene/gl/ball_mapper.hpp"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShaderProgram.h>

#include <cstddef>
#include <string>

#include "ui/scene/gl/ball_shader.hpp"
#include "ui/scene/mesh/vtk_arrays.hpp"

namespace alphascope {

vtkStandardNewMacro(BallMapper);

BallMapper::BallMapper() {
  this->SetScaleArray(kRadiusArray);
}

BallMapper::~BallMapper() = default;

void BallMapper::GetShaderTemplate(std::map<vtkShader::Type, vtkShader*> shaders,
                                   vtkRenderer* renderer, vtkActor* actor) {
  this->Superclass::GetShaderTemplate(shaders, renderer, actor);
  shaders.at(vtkShader::Geometry)->SetSource(kBallGeometry);
  if (look_ == BallRendering::usual) return;
  vtkShader* fragment = shaders.at(vtkShader::Fragment);
  std::string source = fragment->GetSource();
  // Our lines follow VTK's own at the mark. cut_shader.cpp replaces the same marks, and its lines
  // come before these.
  const auto append = [&source](const char* mark, const char* lines) {
    vtkShaderProgram::Substitute(source, mark, std::string(mark) + lines, false);
  };
  if (look_ == BallRendering::outline) {
    append("//VTK::Depth::Impl", kOnlyRim);
  } else {
    append("//VTK::Depth::Impl", kInFront);
    append("//VTK::Light::Impl", kDarkRim);
  }
  fragment->SetSource(source);
}

void BallMapper::set_look(BallRendering look) {
  if (look_ == look) return;
  look_ = look;
  this->Modified();
}

void BallMapper::ComputeBounds() {
  vtkMath::UninitializeBounds(this->Bounds);
  vtkPolyData* balls = this->GetInput();
  if (balls == nullptr || balls->GetNumberOfPoints() == 0) return;
  balls->GetCellsBounds(this->Bounds);
  double radii[2] = {0, 0};
  balls->GetPointData()->GetArray(kRadiusArray)->GetRange(radii);
  for (std::size_t k = 0; k < 6; ++k) this->Bounds[k] += k % 2 == 0 ? -radii[1] : radii[1];
}

}  // namespace alphascope
