// Balls whose centres are all in the plane z = 0, drawn in that plane: circles, power diagram and
// the complex as shapes, for the window and for files. Only the picture is computed in doubles;
// what is in the complex was decided before.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

using FlatPoint = std::array<double, 2>;  // Å; y upwards

struct FlatBox {
  FlatPoint low{}, high{};
  double width() const { return high[0] - low[0]; }
  double height() const { return high[1] - low[1]; }
};

// What a shape is, from the lowest to the uppermost on paper.
enum class FlatKind : std::uint8_t {
  grown_disc,     // radius sqrt(r² + α), filled
  cell,           // of the power diagram: a convex polygon
  triangle,       // of the complex
  edge_inside,    // of two triangles of the complex
  edge_boundary,  // of one triangle
  edge_alone,     // of none
  ball,           // the circle of radius r
  empty_ball,     // r² + α < 0: the same circle of a ball that has no grown disc
  vertex,         // centre of a ball in the complex
  no_vertex,      // centre of one that is not: hidden by others, or not there at this alpha
  orthocircle,    // of the chosen simplex
  orthocentre
};

struct FlatShape {
  FlatKind kind = FlatKind::vertex;
  std::vector<FlatPoint> points;  // a polygon's corners, an edge's ends, a circle's centre
  double radius = 0;              // Å, of circles
  std::vector<BallIndex> balls;   // whose it is, ascending
};

struct FlatContent {
  bool discs = true, cells = true, complex = true;
  std::vector<BallIndex> chosen = {};  // one to three balls, whose orthocircle is drawn; none
};

// Every centre is in the plane z = 0. Of no balls: true.
bool is_flat(const BallSet& balls);

// Of all grown discs, and of balls, with a margin; never empty.
FlatBox box_of(const BallSet& balls, double alpha_angstrom2);

// `complex` is of these balls. Cells are cut at the box. O(n²) for n balls. Throws
// std::invalid_argument when the balls are not flat.
std::vector<FlatShape> flat_shapes(const BallSet& balls, const AlphaComplex& complex,
                                   const FlatBox& box, const FlatContent& content = {});

// The points of the box whose power to this ball is the least, counter-clockwise; empty where it
// has none. Of balls with one centre and radius the first has the cell.
std::vector<FlatPoint> power_cell(const BallSet& balls, BallIndex ball, const FlatBox& box);

// The circle that is orthogonal to those of one to three balls, of all such the least. A negative
// square of the radius: it is imaginary.
struct Orthocircle {
  FlatPoint centre{};
  double squared_radius = 0;  // Å²
  bool any = false;           // else there is none: three centres in a line, two in a point
};
Orthocircle orthocircle(const BallSet& balls, const std::vector<BallIndex>& of);

}  // namespace alphascope
