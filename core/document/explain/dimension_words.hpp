// What a complex is called whose centres all lie in a plane, on a line or at one point, where
// triangles, edges or vertices are the largest simplices (core/complex/own_dimension.hpp).
#pragma once

#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// "in the plane", "on the line", "at the point"; of 3 "in space".
const char* where_text(int dimension);
// "in a plane", "on a line", "at one point"; of 3 "in space".
const char* lie_text(int dimension);

// "In the plane: 4 of 5 centres (4 on the boundary, 0 inside, 0 alone), 5 edges (…), 2 triangles,
// Euler number 1". Empty in space, of no balls, and where only tetrahedra were computed.
std::string own_counts_text(const BallSet& balls, const AlphaComplex& complex);

}  // namespace alphascope
