// SPDX-License-Identifier: GPL-3.0-or-later
// Five balls with distinct centres for predicates: random, nearly degenerate, and at the proven
// bounds of filters and integer widths.
#pragma once

#include "tests/support/random_balls.hpp"

namespace alphascope::testing {

inline constexpr int kFiveBallKinds = 16;

// `kind` is 0 to kFiveBallKinds - 1.
BallSet five_balls(Random& random, int kind);
const char* kind_of_five(int kind);

}  // namespace alphascope::testing
