// SPDX-License-Identifier: GPL-3.0-or-later
// Lines added to VTK's fragment shaders, and to the geometry shader of BallMapper, for a cut. They
// use names of vtkOpenGLSphereMapper (VTK 9.1). EyePos and EyeDir are the ray, in units of the
// ball's radius around its centre. b and d belong to the quadratic equation for the points where
// the ray meets the ball.
#include "ui/scene/gl/cut_shader.hpp"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <cstring>
#include <string>

#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

constexpr const char* kPlaneNames[] = {"cutPlane0", "cutPlane1"};
constexpr const char* kDepth = "//VTK::Depth::Impl";
constexpr const char* kLight = "//VTK::Light::Impl";
constexpr const char* kClip = "//VTK::Clip::Impl";
// A darker rim separates caps of the same colour.
constexpr double kRim = 0.08;  // Å
constexpr double kRimShade = 0.6;
constexpr const char* kClipDeclared = "//VTK::Clip::Dec";

// The planes are in the coordinates of gl_FragCoord, which every fragment shader knows. So the
// vertex shader need not hand over a position.
constexpr const char* kCutMesh = R"(
  if (dot(cutPlane0, vec4(gl_FragCoord.xyz, 1.0)) < 0.0) discard;
  if (dot(cutPlane1, vec4(gl_FragCoord.xyz, 1.0)) < 0.0) discard;
)";

// Clips the ray's interval inside the ball by both planes. A cap is drawn where the clipped
// interval begins at a plane. For back faces of translucent balls (invertedDepth < 0) the end of
// the interval counts. An interval that begins behind the eye is discarded, as in picking.
std::string cut_ball() {
  return R"(
  bool isCap = false;
  float capShade = 1.0;
  {
    float enter = (-b - sqrt(d)) * 0.5, leave = (-b + sqrt(d)) * 0.5;
    vec3 enterNormal = vec3(0.0), leaveNormal = vec3(0.0);
    bool enterCap = false, leaveCap = false;
    for (int k = 0; k < 2; ++k) {
      vec4 plane = k == 0 ? cutPlane0 : cutPlane1;
      float at = dot(plane.xyz, centerVCVSOutput + radiusVCVSOutput * EyePos) + plane.w;
      float by = radiusVCVSOutput * dot(plane.xyz, EyeDir);
      if (by > 0.0) {
        if (-at / by > enter) { enter = -at / by; enterNormal = -plane.xyz; enterCap = true; }
      } else if (by < 0.0) {
        if (-at / by < leave) { leave = -at / by; leaveNormal = -plane.xyz; leaveCap = true; }
      } else if (at < 0.0) {
        discard;
      }
    }
    if (!(enter < leave)) discard;
    if (cameraParallel == 0) {
      float eye = -dot(EyePos + centerVCVSOutput / radiusVCVSOutput, EyeDir);
      if ((invertedDepth < 0.0 ? leave : enter) < eye) discard;
    }
    isCap = invertedDepth < 0.0 ? leaveCap : enterCap;
    if (isCap) {
      vec3 place = EyePos + (invertedDepth < 0.0 ? leave : enter) * EyeDir;
      float power = radiusVCVSOutput * radiusVCVSOutput * (1.0 - dot(place, place));
      vec4 plane = vec4(invertedDepth < 0.0 ? leaveNormal : enterNormal, 0.0);
      float away = dot(plane.xyz, place);  // of the plane from the centre
      float rim = sqrt(max(0.0, 1.0 - away * away)) - length(place - away * plane.xyz);
      if (rim * radiusVCVSOutput < )" +
         std::to_string(kRim) + ") capShade = " + std::to_string(kRimShade) + R"(;
      float lift = )" +
         std::to_string(kLeastCapLift) + " + " + std::to_string(kCapLift) + R"( * power;
      normalVCVSOutput = invertedDepth * plane.xyz;
      vertexVC.xyz = radiusVCVSOutput * place + centerVCVSOutput;
      vec4 lifted = VCDCMatrix * vec4(vertexVC.xyz - lift * EyeDir, 1.0);
      gl_FragDepth = (lifted.z / lifted.w + 1.0) / 2.0;
    }
  }
)";
}

// A cap has exactly its ball's colour, whatever the light, so that the ball can be recognised.
constexpr const char* kFlatCap = R"(
  if (isCap) gl_FragData[0] = vec4(capShade * (ambientColor + diffuseColor), gl_FragData[0].a);
)";

// The names are those of kRodsMet. Like cut_ball(), but only the beginning of the interval counts.
constexpr const char* kCutRod = "//ALPHASCOPE::CutRod";
constexpr const char* kRodClipped = R"(
    vec3 capNormal = vec3(0.0);
    {
      float leave = way, left = rayAlong > 0.0 ? length2 + 1.0 : -1.0;
      if (a > 1e-6 * length2) {
        leave = (-b + sqrt(d)) / a;
        left = startAlong + leave * rayAlong;
      }
      if (left <= 0.0 || left >= length2) {
        vec3 fromEnd = left <= 0.0 ? start : start - rodAlong;
        float e = dot(fromEnd, ray);
        leave = -e + sqrt(max(0.0, e * e - dot(fromEnd, fromEnd) + square));
      }
      for (int k = 0; k < 2; ++k) {
        vec4 plane = k == 0 ? cutPlane0 : cutPlane1;
        float at = dot(plane.xyz, rodFrom.xyz + start) + plane.w;
        float by = dot(plane.xyz, ray);
        if (by > 0.0) {
          if (-at / by > way) { way = -at / by; capNormal = -plane.xyz; rodIsCap = true; }
        } else if (by < 0.0) {
          leave = min(leave, -at / by);
        } else if (at < 0.0) {
          discard;
        }
      }
      if (!(way < leave)) discard;
      if (rodIsCap) reached = clamp(startAlong + way * rayAlong, 0.0, length2);
    }
)";
constexpr const char* kCapOfRod = "//ALPHASCOPE::CapOfRod";
constexpr const char* kRodCapped = R"(
    if (rodIsCap) normalVCVSOutput = capNormal;
)";
constexpr const char* kFlatRodCap = R"(
  if (rodIsCap) gl_FragData[0] = vec4(ambientColor + diffuseColor, gl_FragData[0].a);
)";
constexpr const char* kFlatInside = R"(
  if (!gl_FrontFacing) gl_FragData[0] = vec4(ambientColor + diffuseColor, gl_FragData[0].a);
)";

constexpr const char* kGeometryPlanes = R"(
#define BALLS_ARE_CUT
uniform vec4 cutPlane0;
uniform vec4 cutPlane1;
)";
// Skips balls that a plane removes completely.
constexpr const char* kSkipBall = R"(
  if (dot(cutPlane0, vec4(gl_in[0].gl_Position.xyz, 1.0)) < -radiusVCVSOutput[0]) return;
  if (dot(cutPlane1, vec4(gl_in[0].gl_Position.xyz, 1.0)) < -radiusVCVSOutput[0]) return;
)";

bool is_cut(vtkActor* actor) {
  return actor->GetShaderProperty()->GetNumberOfShaderReplacements() > 0;
}

void uncut(vtkActor* actor) {
  actor->GetShaderProperty()->ClearAllShaderReplacements();
  actor->GetShaderProperty()->GetFragmentCustomUniforms()->RemoveAllUniforms();
}

// The plane in new coordinates, given in old ones; `to_old` converts points from new to old
// coordinates.
std::array<double, 4> changed(const std::array<double, 4>& plane, vtkMatrix4x4* to_old) {
  std::array<double, 4> result{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      result[static_cast<std::size_t>(column)] +=
          plane[static_cast<std::size_t>(row)] * to_old->GetElement(row, column);
    }
  }
  return result;
}

std::array<float, 4> rounded(const std::array<double, 4>& plane) {
  std::array<float, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = static_cast<float>(plane[i]);
  return result;
}

}  // namespace

void cut_mesh_actor(vtkActor* actor, bool cut) {
  if (cut == is_cut(actor)) return;
  if (!cut) return uncut(actor);
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      kDepth, true, std::string(kCutMesh) + kDepth + "\n", false);
}

void cut_ball_actor(vtkActor* actor, bool cut) {
  if (cut == is_cut(actor)) return;
  if (!cut) return uncut(actor);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->AddFragmentShaderReplacement(kDepth, true, kDepth + cut_ball(), false);
  shaders->AddFragmentShaderReplacement(kLight, true, kLight + std::string(kFlatCap), false);
  shaders->AddGeometryShaderReplacement(kClipDeclared, true, kGeometryPlanes, false);
  shaders->AddGeometryShaderReplacement(kClip, true, kSkipBall, false);
}

void cut_rod_actor(vtkActor* actor, bool cut) {
  if (cut == is_cut(actor)) return;
  if (!cut) return uncut(actor);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->AddFragmentShaderReplacement(kDepth, true,
                                        std::string("bool rodIsCap = false;\n") + kDepth, false);
  shaders->AddFragmentShaderReplacement(kLight, true, kLight + std::string(kFlatRodCap), false);
  shaders->AddFragmentShaderReplacement(kCutRod, false, kRodClipped, false);
  shaders->AddFragmentShaderReplacement(kCapOfRod, false, kRodCapped, false);
}

void cut_closed_actor(vtkActor* actor, bool cut) {
  if (cut == is_cut(actor)) return;
  if (!cut) return uncut(actor);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->AddFragmentShaderReplacement(kDepth, true, std::string(kCutMesh) + kDepth + "\n", false);
  shaders->AddFragmentShaderReplacement(kLight, true, kLight + std::string(kFlatInside), false);
}

CutPlanes::CutPlanes(const Cut& cut, vtkRenderer* renderer, int width, int height) {
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> view, picture, pixels;
  view->DeepCopy(camera->GetViewTransformMatrix());
  view->Invert();
  picture->DeepCopy(
      camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  picture->Invert();
  // Converts pixels and depth to VTK's range from -1 to 1.
  const double size[3] = {double(width), double(height), 1};
  for (int k = 0; k < 3; ++k) {
    pixels->SetElement(k, k, 2 / size[k]);
    pixels->SetElement(k, 3, -1);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    std::array<double, 4> plane{0, 0, 0, 1};  // keeps everything
    if (k < cut.kept.size()) {
      const auto& [n, offset] = cut.kept[k];
      plane = {n[0], n[1], n[2], offset};
    }
    camera_[k] = rounded(changed(plane, view));
    fragment_[k] = rounded(changed(changed(plane, picture), pixels));
  }
}

void CutPlanes::give_to(vtkActor* actor) const {
  give(actor, fragment_);
}

void CutPlanes::give_to_rounded(vtkActor* actor) const {
  give(actor, camera_);
}

void CutPlanes::give(vtkActor* actor, const std::array<Plane, 2>& planes) {
  if (!is_cut(actor)) return;
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  for (std::size_t k = 0; k < 2; ++k) {
    shaders->GetFragmentCustomUniforms()->SetUniform4f(kPlaneNames[k], planes[k].data());
  }
}

}  // namespace alphascope
