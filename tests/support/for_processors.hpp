// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a test once for each kind of vector instructions that this machine has.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace alphascope::testing {

// Calls `test` with each kind chosen.
template <class Test>
void for_processors(const Test& test) {
  const std::vector<std::int64_t> kinds = hwy::SupportedAndGeneratedTargets();
  ASSERT_FALSE(kinds.empty());
  for (const std::int64_t kind : kinds) {
    SCOPED_TRACE(hwy::TargetName(kind));
    hwy::SetSupportedTargetsForTest(kind);
    hwy::GetChosenTarget().Update(kind);
    test();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace alphascope::testing
