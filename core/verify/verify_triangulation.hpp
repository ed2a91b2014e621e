// Checking a triangulation against the definition, without any other computation of it.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"
#include "core/verify/verify.hpp"

namespace alphascope {

// Proves that this is the regular triangulation of these balls, ties broken as CGAL does, or says
// what is wrong. All in integers; why the checks suffice is told in verify_triangulation.cpp. The
// time grows with the number of tetrahedra, and with that of the hull's facets times that of its
// vertices. Works in the caller's task arena. Throws Cancelled.
Verification verify_triangulation(const BallSet& balls, const Triangulation& triangulation,
                                  const RunContext& context = {});

}  // namespace alphascope
