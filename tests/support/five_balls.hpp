// Five balls with distinct centres for predicates: random, nearly degenerate, and at the bounds up
// to which filters and integer widths are proven.
#pragma once

#include "tests/support/random_balls.hpp"

namespace alphascope::testing {

inline constexpr int kFiveBallKinds = 16;

// Of kind 0 to kFiveBallKinds - 1.
BallSet five_balls(Random& random, int kind);
const char* kind_of_five(int kind);

}  // namespace alphascope::testing
