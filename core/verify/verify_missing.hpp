// SPDX-License-Identifier: GPL-3.0-or-later
// The simplices of K_alpha that a complex lacks, found from the definition alone (proof in
// verify_missing.cpp).
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "core/verify/verify_balls.hpp"

namespace alphascope {

// Simplices of K_alpha that are missing. If the lists are empty, no simplex is missing; else there
// may be more than these.
struct MissingSimplices {
  Simplices<1> vertices;
  Simplices<2> edges;
  Simplices<3> triangles;
  Simplices<4> tetrahedra;
};

// Finds missing simplices. `complex` must be closed: it has all faces of its simplices, also if
// only tetrahedra were given. It must be a part of K_alpha, and its classes must follow from its
// simplices. If `tetrahedra_given`, only tetrahedra count as missing, and the rest of K_alpha is
// found on the way. Works in the caller's task arena. Throws Cancelled.
MissingSimplices find_missing(const VerifyBalls& balls, const AlphaComplex& complex,
                              bool tetrahedra_given, const RunContext& context);

}  // namespace alphascope
