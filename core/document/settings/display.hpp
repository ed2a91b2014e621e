// SPDX-License-Identifier: GPL-3.0-or-later
// The things that are drawn of balls and complex, and their look. A change needs a new picture
// only.
#pragma once

#include "core/document/settings/beside_body.hpp"
#include "core/document/settings/paint.hpp"

namespace alphascope {

// Each member has a row in display_fields.cpp.
struct DisplaySettings {
  bool balls = true, tetrahedra = true, boundary = false, triangles = false, edges = false;
  // Draw only those triangles and edges that are faces of no larger simplex.
  bool singular_only = true;
  bool grown_balls = false;  // sqrt((radius + solvent)² + alpha) instead of the radius
  float ball_scale = 0.3f;   // factor on the radius
  float ball_opacity = 1, complex_opacity = 1;
  float cavity_opacity = 0.45f;     // below 1, so that the contents of a cavity are visible
  bool lining_sticks = true;        // residues that line a chosen cavity
  float lining_opacity = 1;         // of these sticks
  float content_opacity = 1;        // of ligands in a chosen cavity
  float shrink = 0;                 // of tetrahedra, 0 to 0.9
  float edge_thickness = 0.12f;     // Å; at least 1.5 pixels are drawn
  bool smooth_boundary = false;     // smooth light on the boundary
  Paint ball_paint, complex_paint;  // colours of balls and of simplices
  bool ambient_occlusion = true;
  float shadow_strength = 1;  // of the soft shadows; 0: none
  float depth_cue = 0.4f;     // share of the background colour at the greatest depth; 0: nothing
                              // fades
  float outlines = 1.5f;      // width, pixels at scale 1; 0: none
  float face_lines = 1;       // width of darker lines around faces, pixels at scale 1; 0: none
  int samples = 16;           // of each pixel of the picture at rest
  bool orthographic = false;  // no perspective: parallel lines stay parallel
  AtomsBesideBody beside;
  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

}  // namespace alphascope
