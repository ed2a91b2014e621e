// SPDX-License-Identifier: GPL-3.0-or-later
// The fragment shader of FinishPass. For finish_pass.cpp only.
#pragma once

#include <string>

namespace alphascope {

// Positions are in the camera's coordinates, in Å: x right, y up, z towards the viewer.
//
// Occlusion is summed over a spiral of taps around the pixel, on two scales. A tap darkens the
// pixel the more, the steeper its point rises above the surface, and less at a distance. The spiral
// is turned by one of sixteen angles. The angle depends on the sample and on the pixel's place in
// its block of 4 x 4. After sixteen samples every pixel has had all angles, so that no pattern is
// left.
//
// A pixel is in shadow if a ray towards the key light passes closely behind something visible. The
// ray has a limited length. The light is a disc: each pixel of a block and each sample uses another
// point of it.
//
// An outline is drawn on the farther surface, if a nearer one is in front by more than the jump.
//
// With TRANSLUCENT defined, the input is the complete picture. Only translucent fronts that nothing
// opaque hides are then darkened, faded and outlined, in proportion to their opacity.
inline constexpr const char* kFinishShader = R"(//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D colours;
uniform sampler2D depths;
uniform vec4 depthOfNdc;    // elements 22, 23, 32, 33 of the projection, counted from 0
uniform vec2 scaleOfNdc;    // 00, 11
uniform vec4 shiftOfNdc;    // 02, 03, 12, 13
uniform ivec2 size;         // pixels
uniform int tapCount;       // of each scale; 0: no occlusion
uniform int turn;           // of the spiral, of sixteen
uniform vec2 radii;         // of both scales, Å
uniform float strength;     // of occlusion and shadows, 0 to 1
uniform vec3 light;         // towards the key light
uniform float shadowReach;  // of shadows, Å
uniform vec3 cue;           // how much of the farthest is background; from and to which depth, Å
uniform vec2 outline;    // width in pixels, 0: none; jump in Å
uniform vec4 background;    // alpha 0: a transparent picture
uniform vec3 lineColour;
#ifdef TRANSLUCENT
uniform sampler2D fronts;   // depths of what is translucent
uniform float opacity;      // its, 0 to 1
#endif

// Nearer is what is drawn in front of everything: it is no body, and neither darkens nor is darkened.
const float kMarks = 0.002;

// Of what is seen first.
float depthAt(ivec2 at) {
  at = clamp(at, ivec2(0), size - 1);
  float depth = texelFetch(depths, at, 0).r;
#ifdef TRANSLUCENT
  depth = min(depth, texelFetch(fronts, at, 0).r);
#endif
  return depth;
}
// How much of a pixel this pass is about.
float shareOf(ivec2 at) {
#ifdef TRANSLUCENT
  at = clamp(at, ivec2(0), size - 1);
  return texelFetch(fronts, at, 0).r < texelFetch(depths, at, 0).r ? opacity : 0.0;
#else
  return 1.0;
#endif
}
float zOf(float depth) {
  float n = 2.0 * depth - 1.0;
  return (depthOfNdc.w * n - depthOfNdc.y) / (depthOfNdc.x - depthOfNdc.z * n);
}
vec3 placeAt(ivec2 at, float depth) {
  float z = zOf(depth);
  vec2 ndc = (vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0;
  float w = depthOfNdc.z * z + depthOfNdc.w;
  return vec3((ndc * w - shiftOfNdc.xz * z - shiftOfNdc.yw) / scaleOfNdc, z);
}
vec3 smaller(vec3 a, vec3 b) {
  return abs(a.z) < abs(b.z) ? a : b;
}
vec3 normalAt(ivec2 at, vec3 place) {
  vec3 right = placeAt(at + ivec2(1, 0), depthAt(at + ivec2(1, 0))) - place;
  vec3 left = place - placeAt(at - ivec2(1, 0), depthAt(at - ivec2(1, 0)));
  vec3 above = placeAt(at + ivec2(0, 1), depthAt(at + ivec2(0, 1))) - place;
  vec3 below = place - placeAt(at - ivec2(0, 1), depthAt(at - ivec2(0, 1)));
  return normalize(cross(smaller(right, left), smaller(above, below)));
}
// Of a place on one scale, 0 to 1.
float occlusion(ivec2 at, vec3 place, vec3 normal, float radius, vec2 direction, float first,
                int taps) {
  float w = depthOfNdc.z * place.z + depthOfNdc.w;
  float pixels = radius * scaleOfNdc.y / w * 0.5 * float(size.y);
  pixels = clamp(pixels, 2.0, 0.4 * float(size.y));
  float sum = 0.0;
  for (int i = 0; i < taps; ++i) {
    float share = (float(i) + first) / float(taps);
    ivec2 there = at + ivec2(round(direction * (share * pixels)));
    direction = vec2(-0.7373688 * direction.x - 0.6754903 * direction.y,
                     0.6754903 * direction.x - 0.7373688 * direction.y);  // the golden angle
    float depth = depthAt(there);
    vec3 away = placeAt(there, depth) - place;
    float distance = length(away) + 1e-6;
    float near = depth <= kMarks ? 0.0 : max(0.0, 1.0 - distance / (2.0 * radius));
    sum += near * max(0.0, dot(away, normal) / distance - 0.1);
  }
  return sum / float(max(taps, 1));
}
// 1: all of the key light arrives; of what it does not reach anyway, too.
float lit(vec3 place, vec3 normal, vec2 spread, float first, int taps) {
  vec3 towards = normalize(light + 0.12 * vec3(spread, 0.0));
  float facing = smoothstep(0.0, 0.25, dot(normal, towards));
  if (facing <= 0.0) return 1.0;
  vec3 from = place + 0.02 * shadowReach * normal;
  float behind = 0.0;
  for (int i = 0; i < taps; ++i) {
    float share = (float(i) + first) / float(taps);
    vec3 there = from + (share * share * shadowReach) * towards;
    float w = depthOfNdc.z * there.z + depthOfNdc.w;
    vec2 ndc = (scaleOfNdc * there.xy + shiftOfNdc.xz * there.z + shiftOfNdc.yw) / w;
    float depth = depthAt(ivec2((0.5 * ndc + 0.5) * vec2(size)));
    float ahead = depth <= kMarks ? 0.0 : zOf(depth) - there.z;
    if (ahead > 0.01 * shadowReach && ahead < 0.35 * shadowReach) {
      behind = 1.0 - share;  // far away the shadow of a small thing is lost
      break;
    }
  }
  return 1.0 - strength * 0.4 * facing * smoothstep(0.0, 0.3, behind);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 colour = texelFetch(colours, at, 0);
  float depth = depthAt(at);
  bool drawn = depth < 1.0;
  bool mark = depth <= kMarks;
  float share = shareOf(at);
  vec3 place = placeAt(at, depth);
  float visible = 1.0;
#ifdef OCCLUSION
  int taps = drawn && !mark && share > 0.0 ? tapCount : 0;
  if (taps > 0) {
    vec3 normal = normalAt(at, place);
    int cell = (at.x & 3) + 4 * (at.y & 3);
    float angle = 0.3926991 * float((cell * 7 + turn) & 15);
    vec2 direction = vec2(cos(angle), sin(angle));
    float first = (float((cell * 5 + turn * 3) & 15) + 0.5) / 16.0;
    float close = occlusion(at, place, normal, radii.x, direction, first, taps);
    // Of the large scale the viewer's side counts: how deep a place lies, not how it is turned.
    vec3 towards = normalize(normal + vec3(0.0, 0.0, 1.0));
    float wide = occlusion(at, place, towards, radii.y, direction.yx, first, taps);
    visible = max(0.0, 1.0 - strength * 1.6 * close) * max(0.0, 1.0 - strength * 2.4 * wide);
    visible *= lit(place, normal, direction * sqrt(first), first, taps);
  }
#endif
  float nearest = 1.0;  // depth in the circle around the pixel, without marks
  int corners = outline.x > 0.0 && !mark ? 8 : 0;
  vec2 by = outline.x * vec2(0.9238795, 0.3826834);
  for (int i = 0; i < corners; ++i) {
    ivec2 beside = ivec2(gl_FragCoord.xy + by);
    float there = depthAt(beside);
    nearest = there > kMarks && max(share, shareOf(beside)) > 0.0 ? min(nearest, there) : nearest;
    by = 0.7071068 * vec2(by.x - by.y, by.x + by.y);
  }
  float ahead = -zOf(nearest);
  float line = smoothstep(0.7, 1.3, (-place.z - ahead) / outline.y);
  float faded = drawn && !mark ? cue.x * clamp((-place.z - cue.y) / (cue.z - cue.y), 0.0, 1.0) : 0.0;
  faded *= share;
  colour.rgb *= mix(1.0, visible, share);
  colour = mix(colour, vec4(background.rgb * background.a, background.a), faded);
  float lineFaded = cue.x * clamp((ahead - cue.y) / (cue.z - cue.y), 0.0, 1.0);
  line *= 0.85 * (1.0 - lineFaded);
#ifdef TRANSLUCENT
  line *= min(1.0, 2.0 * opacity);  // of what is hardly there, hardly a line
#endif
  gl_FragData[0] = mix(colour, vec4(lineColour, 1.0), line);
}
)";

inline std::string finish_shader(bool occlusion, bool translucent) {
  return std::string("//VTK::System::Dec\n") + (occlusion ? "#define OCCLUSION\n" : "") +
         (translucent ? "#define TRANSLUCENT\n" : "") + kFinishShader;
}

}  // namespace alphascope
