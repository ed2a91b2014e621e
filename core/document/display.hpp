// What is drawn of balls and complex, and how. A change of these only needs a new picture.
#pragma once

#include <cstdint>

namespace alphascope {

enum class ColourBy : std::uint8_t { element, chain, single, alpha };  // alpha: simplices only

struct DisplayControls {
  bool balls = true, tetrahedra = true, boundary = false, triangles = false, edges = false;
  bool singular_only = true;  // triangles and edges that are faces of nothing larger
  bool grown_balls = false;   // sqrt((radius + solvent)² + alpha) instead of the radius
  float ball_scale = 0.3f;    // times the radius
  float ball_opacity = 1, complex_opacity = 1;
  float shrink = 0;  // of tetrahedra, 0 to 0.9
  ColourBy ball_colour = ColourBy::chain, complex_colour = ColourBy::chain;
  bool ambient_occlusion = true;
  friend bool operator==(const DisplayControls&, const DisplayControls&) = default;
};

}  // namespace alphascope
