// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry shader of BallMapper, and lines of its fragment shader. For each ball the geometry
// shader makes a triangle that just covers the visible part. It replaces VTK's, whose triangle
// covers a ball only without perspective. Marks ("//VTK::") and names are those of VTK 9.1. For
// ball_mapper.cpp only.
#pragma once

namespace alphascope {

// With perspective, the lines of sight that touch a ball form a cone. The triangle lies in the
// plane through the ball's centre, at a right angle to the line from the eye. Let r be the ball's
// radius and d its centre's distance from the eye. The cone meets that plane in a circle of radius
// r d / sqrt(d² - r²). This is more than r, and grows as the ball comes nearer. The triangle
// encloses that circle. The fragment shader writes the depth, so the near plane need not cut the
// triangle off. It is cut off only at a tenth of d before the eye, which no visible part of it
// reaches. A ball around the eye is not visible from outside. From inside (translucent balls), and
// for its caps, it may cover the whole picture.
inline constexpr const char* kBallGeometry = R"(//VTK::System::Dec
//VTK::PrimID::Dec
//VTK::Color::Dec
layout(points) in;
layout(triangle_strip, max_vertices = 3) out;
uniform int cameraParallel;
uniform mat4 VCDCMatrix;
uniform float invertedDepth;
in float radiusVCVSOutput[];
out float radiusVCGSOutput;
out vec4 vertexVCGSOutput;
out vec3 centerVCGSOutput;
//VTK::Clip::Dec
//VTK::Picking::Dec
void main()
{
  int i = 0;  // for VTK's lines
  radiusVCGSOutput = radiusVCVSOutput[0];
  vec3 centre = gl_in[0].gl_Position.xyz / gl_in[0].gl_Position.w;
  vec3 right = vec3(1.0, 0.0, 0.0), up = vec3(0.0, 1.0, 0.0);
  float away = length(centre);
  bool around = false;  // the eye
  if (cameraParallel == 0) {
    float touching = away * away - radiusVCVSOutput[0] * radiusVCVSOutput[0];
    around = !(touching > 1e-6 * away * away);
    if (!around) {
      vec3 towards = -centre / away;
      up = normalize(cross(towards, abs(towards.x) < 0.9 ? right : vec3(0.0, 0.0, 1.0)));
      right = cross(up, towards);
      float wider = away / sqrt(touching);
      up *= wider;
      right *= wider;
    }
  }
#ifndef BALLS_ARE_CUT
  if (around && invertedDepth > 0.0) return;
#endif
  //VTK::PrimID::Impl
  //VTK::Clip::Impl
  //VTK::Color::Impl
  centerVCGSOutput = centre;
  //VTK::Picking::Impl
  for (int corner = 0; corner < 3; ++corner) {
    if (around) {
      vec2 place = corner == 0 ? vec2(-1.0, -1.0) : corner == 1 ? vec2(3.0, -1.0) : vec2(-1.0, 3.0);
      vec2 shift = vec2(VCDCMatrix[2][0], VCDCMatrix[2][1]);
      vec2 scale = vec2(VCDCMatrix[0][0], VCDCMatrix[1][1]);
      vertexVCGSOutput = vec4((place + shift) / scale, -1.0, 1.0);
      gl_Position = vec4(place, 0.0, 1.0);
    } else {
      vec2 place = corner == 0   ? vec2(-1.7320508, -1.0)
                   : corner == 1 ? vec2(1.7320508, -1.0)
                                 : vec2(0.0, 2.0);
      place *= radiusVCVSOutput[0];
      vertexVCGSOutput = vec4(centre + place.x * right + place.y * up, 1.0);
      gl_Position = VCDCMatrix * vertexVCGSOutput;
      if (cameraParallel == 0) gl_Position.z = -0.1 * away;
    }
    EmitVertex();
  }
  EndPrimitive();
}
)";

// Lines of fragment shaders, placed after VTK's lines that compute where the ray meets the ball.
// The macro is the cosine between normal and line of sight: 1 in the middle of the ball, 0 at its
// outline.
#define ALPHASCOPE_FACING \
  "dot(normalVCVSOutput, cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz))"

// Keeps the outer fifth of the visible radius: sqrt(1 - 0.6²) = 0.8.
inline constexpr const char* kOnlyRim = "\n  if (" ALPHASCOPE_FACING " > 0.6) discard;\n";
// Scales the depth. So these balls are nearer than everything else, and keep their order among
// themselves. FinishPass does not shade pixels with depths below its kMarks (0.002).
#define ALPHASCOPE_FRONT_DEPTH 0.001
#define ALPHASCOPE_TEXT_OF(number) #number
#define ALPHASCOPE_NUMBER_TEXT(number) ALPHASCOPE_TEXT_OF(number)
inline constexpr const char* kInFront =
    "\n  gl_FragDepth *= " ALPHASCOPE_NUMBER_TEXT(ALPHASCOPE_FRONT_DEPTH) ";\n";
inline constexpr float kFrontDepth = ALPHASCOPE_FRONT_DEPTH;  // for rods
inline constexpr const char* kDarkRim =
    "\n  if (" ALPHASCOPE_FACING " < 0.4) gl_FragData[0].rgb *= 0.15;\n";

#undef ALPHASCOPE_FACING
#undef ALPHASCOPE_FRONT_DEPTH
#undef ALPHASCOPE_TEXT_OF
#undef ALPHASCOPE_NUMBER_TEXT

}  // namespace alphascope
