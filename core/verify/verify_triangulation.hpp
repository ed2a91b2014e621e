// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a triangulation against the definition, without computing one in another way.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"
#include "core/verify/verify.hpp"

namespace alphascope {

struct BallSet;

// Proves that this is the regular triangulation of these balls, with ties broken as CGAL does, or
// reports what is wrong. All in integers; verify_triangulation.cpp explains why the checks are
// enough. The time grows with the number of tetrahedra, and with the number of the hull's facets
// times that of its vertices. Works in the caller's task arena. Throws Cancelled.
Verification verify_triangulation(const BallSet& balls, const Triangulation& triangulation,
                                  const RunContext& context = {});

}  // namespace alphascope
