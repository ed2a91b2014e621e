// Checking a complex against the definition of K_alpha, without any other computation of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct Verification {
  std::size_t checks = 0;             // single facts looked at
  std::size_t failures = 0;           // of them false
  std::vector<std::string> messages;  // the first of the failures, each naming its simplex
  bool ok() const { return failures == 0; }
};

// How it is found which simplices there must be.
enum class VerifyBy {
  whatever_is_faster,
  search,        // among all near balls
  triangulation  // from the regular triangulation, proven first; by a search where that fails
};

// Proves that a complex is K_alpha of these balls, or says what is wrong. Independent of every
// engine and of all floating-point filters: near balls, conflicts, ties, ortho-radii and alpha
// values are found in integers. What is checked:
//  - lists are sorted, free of duplicates, made of existing balls; sizes of the arrays agree;
//  - closure: every face of a simplex is there, with no larger alpha value;
//  - each simplex is in the regular triangulation, ties broken as CGAL does, and has an
//  ortho-radius
//    of at most alpha; a face in conflict with some ball has the least value of its cofaces, all
//    others their own ortho-radius;
//  - the classes follow from the simplices;
//  - nothing is missing (verify_missing.cpp says why that is known): this is looked at only when
//    all of the above holds.
// Of a tetrahedra-only complex, values and classes are not looked at, and only tetrahedra can be
// missing. The time of a search grows with the number of simplices times that of near balls; where
// many are near, the regular triangulation is made, proven in integers (verify_triangulation.hpp)
// and cut off at alpha (verify_proven.hpp). Works in the caller's task arena. Throws Cancelled.
Verification verify(const BallSet& balls, const AlphaComplex& complex,
                    const RunContext& context = {}, VerifyBy by = VerifyBy::whatever_is_faster);

// True when every simplex of `smaller` is one of `larger`: K grows with alpha.
bool is_subcomplex(const AlphaComplex& smaller, const AlphaComplex& larger);

}  // namespace alphascope
