// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that CellMapper adds to VTK's shaders; for cell_mapper.cpp only. Positions are in Å: in
// vertex shaders ("MC") relative to BallGeometry::origin, in fragment shaders ("VC") in the
// camera's coordinates.
#pragma once

namespace alphascope {

// Unpacks a PackedColour into components from 0 to 1. For both shaders.
inline constexpr const char* kColourOf = R"(
vec3 colourOf(uint bits) {
  return vec3(float(bits & 255u), float(bits >> 8 & 255u), float(bits >> 16 & 255u)) / 255.0;
}
)";

// A face has three balls and a colour. A tetrahedron has four balls; its face f is opposite to
// corner f. In the fragment shader, component k of cellCorner is 1 at corner k and 0 on the
// opposite side.
inline constexpr const char* kFacesDeclared = R"(
uniform usamplerBuffer cells;
uniform usamplerBuffer cellColours;
uniform samplerBuffer places;
uniform samplerBuffer normals;
uniform mat3 cellToCamera;
uniform float shrink;
uniform int whole;
uniform int outward;  // of whole tetrahedra: faces are counterclockwise from outside
uniform int smoothed;
uniform int litByFace;
flat out uint cellColourVSOutput;
flat out uint faceColourVSOutput;  // where litByFace: with its light, 10 bits each, up to 2
out vec2 cellCornerVSOutput;
out vec3 cellNormalVSOutput;
vec4 vertexMC;
vec3 placeOf(uint ball) { return texelFetch(places, int(ball)).xyz; }
// VTK's; of lights, as many as the scene has.
uniform int cameraParallel;
uniform vec3 lightColor0, lightColor1, lightColor2;
uniform vec3 lightDirectionVC0, lightDirectionVC1, lightDirectionVC2;
uniform float ambientIntensity, diffuseIntensity, specularIntensity, specularPowerUniform;
// What VTK does for each pixel. All vectors have the length 1.
vec3 lit(vec3 lightColour, vec3 direction, vec3 normal, vec3 toEye, vec3 colour) {
  float facing = dot(normal, -direction);
  if (facing <= 0.0) return vec3(0.0);
  float shine = pow(max(0.0, dot(reflect(direction, normal), toEye)), specularPowerUniform);
  return lightColour * (diffuseIntensity * facing * colour + specularIntensity * shine);
}
uint litFace(vec3 normal, vec3 toEye, vec3 colour) {
  if ((cameraParallel != 0 ? normal.z : dot(normal, toEye)) < 0.0) normal = -normal;
  vec3 sum = ambientIntensity * colour;
  sum += lit(lightColor0, lightDirectionVC0, normal, toEye, colour);
  sum += lit(lightColor1, lightDirectionVC1, normal, toEye, colour);
  sum += lit(lightColor2, lightDirectionVC2, normal, toEye, colour);
  uvec3 bits = uvec3(clamp(511.5 * sum + 0.5, 0.0, 1023.0));
  return bits.x | bits.y << 10 | bits.z << 20;
}
)";
inline constexpr const char* kFacesFetched = R"(
  {
    uint colour;
    vec3 place;
    int corner = gl_VertexID % 3;
    vec3 first, second, third;  // the face's corners
    cellNormalVSOutput = vec3(0.0);
    if (whole != 0) {
      int cell = gl_VertexID / 12;
      int face = gl_VertexID % 12 / 3;
      uvec4 balls = texelFetch(cells, cell);
      if (litByFace != 0) {
        first = placeOf(balls[face == 0 ? 1 : 0]);
        second = placeOf(balls[face < 2 ? 2 : 1]);
        third = placeOf(balls[face < 3 ? 3 : 2]);
      }
      if (outward != 0) {
        vec3 apex = placeOf(balls.x);
        float volume = dot(cross(placeOf(balls.y) - apex, placeOf(balls.z) - apex),
                           placeOf(balls.w) - apex);
        if ((volume > 0.0) == ((face & 1) != 0)) corner = (3 - corner) % 3;
      }
      place = placeOf(balls[corner < face ? corner : corner + 1]);
      if (shrink > 0.0) {
        vec3 centre = 0.25 * placeOf(balls.x) + 0.25 * placeOf(balls.y);
        centre += 0.25 * placeOf(balls.z);
        centre += 0.25 * placeOf(balls.w);
        place += shrink * (centre - place);
      }
      colour = texelFetch(cellColours, cell).x;
    } else {
      uvec4 face = texelFetch(cells, gl_VertexID / 3);
      place = placeOf(face[corner]);
      if (litByFace != 0) {
        first = placeOf(face.x);
        second = placeOf(face.y);
        third = placeOf(face.z);
      }
      colour = face.w;
      if (smoothed != 0) {
        cellNormalVSOutput = cellToCamera * texelFetch(normals, int(face[corner])).xyz;
      }
    }
    vertexMC = vec4(place, 1.0);
    cellCornerVSOutput = vec2(corner == 0, corner == 1);
    cellColourVSOutput = colour;
    faceColourVSOutput = 0u;
    if (litByFace != 0) {
      vec3 normal = normalize(cellToCamera * cross(second - first, third - first));
      vec3 toEye = normalize(-(MCVCMatrix * vertexMC).xyz);
      faceColourVSOutput = litFace(normal, toEye, colourOf(colour));
    }
  }
)";
inline constexpr const char* kFacesToFragments = R"(
uniform int smoothed;
uniform float faceLines;  // of the darker lines around a face, pixels; 0: none
flat in uint cellColourVSOutput;
flat in uint faceColourVSOutput;
in vec2 cellCornerVSOutput;
in vec3 cellNormalVSOutput;
)";
// These lines come before any branch: derivatives need values of neighbouring pixels.
inline constexpr const char* kFacesUniform = R"(
  vec3 cellCorner = vec3(cellCornerVSOutput, 1.0 - cellCornerVSOutput.x - cellCornerVSOutput.y);
  vec3 cellSlope = vec3(0.0);  // of cellCorner, for each pixel
  if (faceLines > 0.0) {
    vec3 right = dFdx(cellCorner), up = dFdy(cellCorner);
    cellSlope = max(sqrt(right * right + up * up), 1e-6);
  }
)";
// Each of two neighbouring faces shows half of a line. Faces about as small as the width of their
// lines have none.
inline constexpr const char* kFacesColoured = R"(
  float cellShade = 1.0;
  if (faceLines > 0.0) {
    vec3 away = cellCorner / cellSlope;  // from the sides, pixels
    float nearest = min(away.x, min(away.y, away.z));
    float height = 1.0 / max(cellSlope.x, max(cellSlope.y, cellSlope.z));
    float line = 1.0 - smoothstep(0.5 * faceLines - 0.5, 0.5 * faceLines + 0.5, nearest);
    cellShade = 1.0 - 0.5 * line * smoothstep(4.0, 14.0, height / faceLines);
  }
  vec3 cellColour = cellShade * colourOf(cellColourVSOutput);
  ambientColor = ambientIntensity * cellColour;
  diffuseColor = diffuseIntensity * cellColour;
)";
// Replaces VTK's light. The shader then needs neither positions nor normals of pixels, which halves
// the outputs of the vertex shader.
inline constexpr const char* kFacesLit = R"(
  uvec3 faceBits = uvec3(faceColourVSOutput, faceColourVSOutput >> 10, faceColourVSOutput >> 20);
  gl_FragData[0] = vec4(cellShade / 511.5 * vec3(faceBits & 1023u), opacity);
)";
// Where sheets of a surface meet in a ball, its mean normal may fit none of them. The face then
// keeps its own normal.
inline constexpr const char* kFacesNormal = R"(
  if (smoothed != 0) {
    vec3 between = normalize(cellNormalVSOutput + vec3(0.0, 0.0, 1e-12));
    if (dot(between, normalVCVSOutput) < 0.0) between = -between;
    if (dot(between, normalVCVSOutput) > 0.2) normalVCVSOutput = between;
  }
)";

// An edge is a rod with round ends. The vertex shader draws a rectangle that covers the rod, at the
// depth of its nearest point. The fragment shader finds where the ray meets the rod.
inline constexpr const char* kRodsDeclared = R"(
uniform usamplerBuffer cells;
uniform samplerBuffer places;
uniform mat4 cellToCamera;
uniform mat4 cameraToPicture;
uniform int parallel;
uniform float radius;
uniform float radiusPerDepth;  // the least, which a thin rod far away still has
flat out vec3 cellColourVSOutput;
flat out vec3 otherColourVSOutput;  // of the half at the second ball
flat out vec4 rodFrom;  // and its radius
flat out vec3 rodAlong;
vec4 vertexMC;
vec3 placeOf(uint ball) {
  return (cellToCamera * vec4(texelFetch(places, int(ball)).xyz, 1.0)).xyz;
}
vec3 towardsEye(vec3 place) { return parallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-place); }
)";
inline constexpr const char* kRodsPlaced = R"(
  {
    uvec4 edge = texelFetch(cells, gl_VertexID / 6);
    vec3 from = placeOf(edge.x), to = placeOf(edge.y);
    vec3 middle = 0.5 * (from + to);
    float thick = max(radius, radiusPerDepth * (parallel != 0 ? 1.0 : -middle.z));
    vec3 eye = towardsEye(middle);
    vec3 along = (to - from) - dot(to - from, eye) * eye;
    float seen = length(along);
    along = seen > 1e-6 ? along / seen : normalize(cross(eye, vec3(0.0, 1.0, 0.1)));
    vec3 across = cross(eye, along);
    // Two triangles: 0 1 2, 2 1 3; bit 0 is the end, bit 1 the side.
    int corner = gl_VertexID % 6;
    corner = corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
    bool end = (corner & 1) != 0;
    vec3 place = end ? to : from;
    float more = 1.1 * thick;
    place += thick * towardsEye(place) + (end ? more : -more) * along;
    place += ((corner & 2) != 0 ? more : -more) * across;
    rodFrom = vec4(from, thick);
    rodAlong = to - from;
    cellColourVSOutput = colourOf(edge.z);
    otherColourVSOutput = colourOf(edge.w);
    vertexVCVSOutput = vec4(place, 1.0);
    gl_Position = cameraToPicture * vertexVCVSOutput;
  }
)";
inline constexpr const char* kRodsToFragments = R"(
uniform float depthScale;  // below 1: in front of everything else
uniform mat4 cameraToPicture;
uniform int parallel;
flat in vec3 cellColourVSOutput;
flat in vec3 otherColourVSOutput;
flat in vec4 rodFrom;
flat in vec3 rodAlong;
)";
// The ray starts on the rectangle, close to the rod. If it started at the eye, rounding in the
// squared distance would exceed the squared radius.
inline constexpr const char* kRodsMet = R"(
  vec3 normalVCVSOutput;
  vec3 rodColour = cellColourVSOutput;
  {
    vec3 start = vertexVC.xyz - rodFrom.xyz;
    vec3 ray = parallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(vertexVC.xyz);
    float square = rodFrom.w * rodFrom.w;
    float length2 = dot(rodAlong, rodAlong), rayAlong = dot(rodAlong, ray);
    float startAlong = dot(rodAlong, start);
    float a = length2 - rayAlong * rayAlong;
    float reached = rayAlong > 0.0 ? -1.0 : length2 + 1.0;  // along the rod; seen from its end
    float way = 0.0;
    float b = length2 * dot(start, ray) - startAlong * rayAlong;
    float c = length2 * (dot(start, start) - square) - startAlong * startAlong;
    float d = b * b - a * c;
    if (a > 1e-6 * length2) {
      if (d < 0.0) discard;
      way = (-b - sqrt(d)) / a;
      reached = startAlong + way * rayAlong;
    }
    if (reached <= 0.0 || reached >= length2) {
      vec3 fromEnd = reached <= 0.0 ? start : start - rodAlong;
      float e = dot(fromEnd, ray);
      float f = e * e - dot(fromEnd, fromEnd) + square;
      if (f < 0.0) discard;
      way = -e - sqrt(f);
      reached = reached <= 0.0 ? 0.0 : length2;
    }
    //ALPHASCOPE::CutRod
    if (2.0 * reached > length2) rodColour = otherColourVSOutput;
    vec3 place = start + way * ray;
    normalVCVSOutput = (place - (length2 > 0.0 ? reached / length2 : 0.0) * rodAlong) / rodFrom.w;
    //ALPHASCOPE::CapOfRod
    vertexVC = vec4(rodFrom.xyz + place, 1.0);
    vec4 drawn = cameraToPicture * vertexVC;
    gl_FragDepth = depthScale * (drawn.z / drawn.w + 1.0) / 2.0;
  }
)";
inline constexpr const char* kRodsColoured = R"(
  ambientColor = ambientIntensity * rodColour;
  diffuseColor = diffuseIntensity * rodColour;
)";

}  // namespace alphascope
