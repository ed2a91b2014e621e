// What is drawn of balls and complex, and how. A change of these only needs a new picture.
#pragma once

#include "core/document/settings/paint.hpp"
#include "core/selection/ball_options.hpp"

namespace alphascope {

// Atoms that the options leave out of the body, and that are drawn beside it: drawn, not computed.
struct AtomsBesideBody {
  bool ligands = true, ions = true, waters = false;
  bool hydrogens = false;  // of all kinds
  friend bool operator==(const AtomsBesideBody&, const AtomsBesideBody&) = default;
};

// Whether an atom of this kind is drawn beside the body, when the options leave it out.
bool shows(const AtomsBesideBody& shown, DropReason reason, Element element);

struct DisplayControls {
  bool balls = true, tetrahedra = true, boundary = false, triangles = false, edges = false;
  bool singular_only = true;  // triangles and edges that are faces of nothing larger
  bool grown_balls = false;   // sqrt((radius + solvent)² + alpha) instead of the radius
  float ball_scale = 0.3f;    // times the radius
  float ball_opacity = 1, complex_opacity = 1;
  float cavity_opacity = 0.45f;     // so that what a cavity holds is seen in it
  float shrink = 0;                 // of tetrahedra, 0 to 0.9
  float edge_thickness = 0.12f;     // of edges, Å; at least a line of 1.5 pixels is drawn
  bool smooth_boundary = false;     // light is interpolated between the boundary's corners
  Paint ball_paint, complex_paint;  // what colours mean
  bool ambient_occlusion = true;
  float depth_cue = 0.4f;     // share of background in what is farthest; 0: nothing fades
  float silhouettes = 1.5f;   // width of outlines, pixels at scale 1; 0: none
  float face_edges = 1;       // width of the darker lines around faces, pixels at scale 1; 0: none
  int samples = 16;           // a pixel of the picture at rest
  bool orthographic = false;  // parallel lines stay parallel: no perspective
  AtomsBesideBody beside;
  friend bool operator==(const DisplayControls&, const DisplayControls&) = default;
};

}  // namespace alphascope
