// SPDX-License-Identifier: GPL-3.0-or-later
// Texts on complexes whose centres all lie in a plane, on a line or at one point. Triangles, edges
// or vertices are the largest simplices there (core/complex/own_dimension.hpp).
#pragma once

#include <string>

namespace alphascope {

struct AlphaComplex;
struct BallSet;

// "at the point", "on the line", "in the plane", "in space" for dimensions 0 to 3.
const char* where_text(int dimension);
// "at one point", "on a line", "in a plane", "in space" for dimensions 0 to 3.
const char* lie_text(int dimension);

// "In the plane: 4 of 5 centres, 5 edges (4 on the boundary, 1 interior, 0 singular), 2 triangles,
// Euler number 1". Empty in space, without balls, and if only tetrahedra were computed.
std::string own_counts_text(const BallSet& balls, const AlphaComplex& complex);

}  // namespace alphascope
