// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of balls whose centres are all in the plane z = 0. Circles, power diagram and complex
// become shapes for the window and for files. Only the picture is computed in doubles; membership
// in the complex is decided elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

struct AlphaComplex;

using FlatPoint = std::array<double, 2>;  // Å; y points upwards

struct FlatBox {
  FlatPoint low{}, high{};
  double width() const { return high[0] - low[0]; }
  double height() const { return high[1] - low[1]; }
};

// The kinds of shapes, in drawing order: the last is on top.
enum class FlatKind : std::uint8_t {
  grown_disc,     // radius sqrt(r² + α), filled
  cell,           // cell of the power diagram, a convex polygon
  triangle,       // triangle of the complex
  edge_inside,    // edge of two triangles of the complex
  edge_boundary,  // edge of one triangle
  edge_alone,     // edge of no triangle
  ball,           // circle of radius r
  // The circle of radius r of a ball without grown disc: r² + α < 0.
  empty_ball,
  vertex,  // centre of a ball in the complex
  // Centre of a ball that is not in the complex: hidden by others, or not yet at this alpha.
  no_vertex,
  orthocircle,  // of the chosen simplex
  orthocentre
};

struct FlatShape {
  FlatKind kind = FlatKind::vertex;
  std::vector<FlatPoint> points;  // corners of a polygon, ends of an edge, or centre of a circle
  double radius = 0;              // Å; for circles
  std::vector<BallIndex> balls;   // balls to which the shape belongs, ascending
};

struct FlatContent {
  bool discs = true, cells = true, complex = true;
  std::vector<BallIndex> chosen = {};  // one to three balls whose orthocircle is drawn; empty: none
};

// Returns whether every centre is in the plane z = 0; true if there are no balls.
bool is_flat(const BallSet& balls);

// A box around all balls and grown discs, with a margin; never empty.
FlatBox box_of(const BallSet& balls, double alpha_angstrom2);

// The shapes of a drawing. `complex` must be of these balls. Cells are cut off at the box. Takes
// O(n²) for n balls. Throws std::invalid_argument if the balls are not flat.
std::vector<FlatShape> flat_shapes(const BallSet& balls, const AlphaComplex& complex,
                                   const FlatBox& box, const FlatContent& content = {});

// The points of the box with the least power to this ball, as a polygon, counterclockwise. Empty if
// the ball has no cell. Among balls with equal centre and radius only the first has a cell.
std::vector<FlatPoint> power_cell(const BallSet& balls, BallIndex ball, const FlatBox& box);

// The smallest circle that is orthogonal to the circles of one to three balls. If its squared
// radius is negative, it is imaginary.
struct Orthocircle {
  FlatPoint centre{};
  double squared_radius = 0;  // Å²
  bool any = false;  // false: there is none, because two centres are equal or three are on a line
};
Orthocircle orthocircle(const BallSet& balls, const std::vector<BallIndex>& of);

}  // namespace alphascope
