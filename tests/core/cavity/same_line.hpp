// SPDX-License-Identifier: GPL-3.0-or-later
// Expects two channels to have the same widths and samples, to the last bit.
#pragma once

#include <gtest/gtest.h>

#include "core/channel/channel.hpp"

namespace alphascope::testing {

inline void expect_same_line(const Channel& a, const Channel& b) {
  EXPECT_EQ(a.widest_angstrom, b.widest_angstrom);
  EXPECT_EQ(a.bottleneck, b.bottleneck);
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t n = 0; n < a.samples.size(); ++n) {
    EXPECT_EQ(a.samples[n].position_angstrom, b.samples[n].position_angstrom);
    EXPECT_EQ(a.samples[n].radius_angstrom, b.samples[n].radius_angstrom);
  }
}

}  // namespace alphascope::testing
