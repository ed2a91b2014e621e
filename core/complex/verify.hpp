// Checking a complex against the definition of K_alpha, without any other computation of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

struct Verification {
  std::size_t checks = 0;             // single facts looked at
  std::size_t failures = 0;           // of them false
  std::vector<std::string> messages;  // the first of the failures, each naming its simplex
  bool ok() const { return failures == 0; }
};

// What must hold of K_alpha of these balls, exactly:
//  - lists are sorted, free of duplicates, made of existing balls; sizes of the arrays agree;
//  - closure: every face of a simplex is there, with no larger alpha value;
//  - the simplex whose ortho-radius is the alpha value has one of at most alpha;
//  - a tetrahedron's alpha value is its ortho-radius, and no ball is in conflict with its
//  orthosphere;
//    a face's is its own ortho-radius, and then no ball is in conflict, or that of a coface, and
//    then the coface's apex is;
//  - the classes follow from the simplices.
// It does not show completeness: that needs every other simplex. Conflicts are looked for among all
// balls near enough, in the caller's task arena. Of a tetrahedra-only complex the last three points
// are checked for the tetrahedra alone.
Verification verify(const BallSet& balls, const AlphaComplex& complex);

// True when every simplex of `smaller` is one of `larger`: K grows with alpha.
bool is_subcomplex(const AlphaComplex& smaller, const AlphaComplex& larger);

}  // namespace alphascope
