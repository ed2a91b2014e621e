// SPDX-License-Identifier: GPL-3.0-or-later
// The expression that selects atoms, as the user types it. Plain data.
#pragma once

#include <string>

namespace alphascope {

struct ExpressionState {
  std::string typed;
  bool entered = false;  // the user entered it, and no answer is shown yet
  std::string shown;     // the selection from which `typed` was last filled
};

}  // namespace alphascope
