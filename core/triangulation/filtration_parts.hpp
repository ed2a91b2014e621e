// SPDX-License-Identifier: GPL-3.0-or-later
// The simplices of a triangulation of dimension 3 with their alpha values and levels.
#pragma once

#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// All of a filtration but the balls of its tetrahedra and vertices, which the triangulation has.
struct FiltrationParts {
  SimplexList<1> vertices;
  SimplexList<2> edges;
  SimplexList<3> triangles;
  ResultArray<float> tetrahedron_values;
  ClassLevelsByDimension levels;
  HashStepsByDimension hash_steps;
  std::string device;  // that made them
};

// Makes all but the hash steps of a filtration: fills the four lists of `top`, and the levels.
// `tetrahedra` are those of the triangulation. Works in the caller's task arena. The result does
// not depend on the number of threads. Throws Cancelled.
void fill_filtration(const BallSet& balls, const Triangulation& triangulation,
                     Simplices<4> tetrahedra, const RunContext& context, AlphaComplex& top,
                     ClassLevelsByDimension& levels);

}  // namespace alphascope
