// What a complex lacks of K_alpha, found from the definition alone (verify_missing.cpp proves it).
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "core/verify/verify_balls.hpp"

namespace alphascope {

// The simplices of K_alpha found to be missing. When none is listed, none is missing; when some
// are, there may be more.
struct MissingSimplices {
  Simplices<1> vertices;
  Simplices<2> edges;
  Simplices<3> triangles;
  Simplices<4> tetrahedra;
};

// `complex` must be closed (all faces of its simplices are in it, also of a tetrahedra-only one),
// all of it must be in K_alpha, and its classes must follow from its simplices. With
// `tetrahedra_given`, only tetrahedra count as missing: the rest of K_alpha is found on the way.
// Works in the caller's task arena. Throws Cancelled.
MissingSimplices find_missing(const VerifyBalls& balls, const AlphaComplex& complex,
                              bool tetrahedra_given, const RunContext& context);

}  // namespace alphascope
