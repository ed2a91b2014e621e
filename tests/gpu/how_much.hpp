// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of tests for a device. Those for the emulated device are smaller, since it is slow.
#pragma once

#include "tests/support/sanitizer.hpp"

namespace alphascope::testing {

// In units of NamedBalls::alpha_unit() of a set.
#ifdef ALPHASCOPE_EMULATED_DEVICE
inline constexpr double kSomeAlphas[] = {-1.0, 0.25, 1.0, 40.0};
inline constexpr int kNumbersOfChunks[] = {5};
// Balls of a large hard set.
inline constexpr int kLarge = unless_sanitized(300, 100), kLargeForTuples = unless_sanitized(24, 8);
#else
inline constexpr double kSomeAlphas[] = {-1.0, 0.0, 0.25, 0.5, 1.0, 3.0, 40.0};
inline constexpr int kNumbersOfChunks[] = {2, 5, 16};
inline constexpr int kLarge = 1000, kLargeForTuples = 35;
#endif

}  // namespace alphascope::testing
