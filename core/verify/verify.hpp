// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a complex against the definition of K_alpha, without computing K_alpha in another way.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

struct Verification {
  std::size_t checks = 0;             // number of facts that were checked
  std::size_t failures = 0;           // number of these that are false
  std::vector<std::string> messages;  // for the first failures; each names its simplex
  bool ok() const { return failures == 0; }
};

// The method by which the simplices that must exist are found.
enum class VerifyBy {
  whatever_is_faster,
  search,        // search among all near balls
  triangulation  // from the regular triangulation, proven first; by search if the proof fails
};

// Proves that a complex is K_alpha of these balls, or reports what is wrong. The proof is
// independent of every engine and of all floating-point filters: near balls, conflicts, ties,
// ortho-radii and alpha values are found in integers. It checks the following:
//  - Lists are sorted, without duplicates, and made of existing balls; the arrays' sizes agree.
//  - Closure: every face of a simplex is in the complex, with no larger alpha value.
//  - Each simplex is in the regular triangulation, with ties broken as CGAL does, and has an
//    ortho-radius of at most alpha. A face in conflict with some ball has the least value of its
//    cofaces, all other simplices have their own ortho-radius.
//  - The classes follow from the simplices.
//  - No simplex is missing (proof in verify_missing.cpp). This is checked only if all of the above
//    holds.
// In a tetrahedra-only complex, values and classes are not checked, and only tetrahedra can be
// missing. The time of a search grows with the number of simplices times that of near balls. If
// many balls are near, the regular triangulation is made, proven in integers
// (verify_triangulation.hpp) and cut off at alpha (verify_proven.hpp). Works in the caller's task
// arena. Throws Cancelled.
Verification verify(const BallSet& balls, const AlphaComplex& complex,
                    const RunContext& context = {}, VerifyBy by = VerifyBy::whatever_is_faster);

// True if every simplex of `smaller` is also in `larger`, as K_alpha grows with alpha.
bool is_subcomplex(const AlphaComplex& smaller, const AlphaComplex& larger);

}  // namespace alphascope
