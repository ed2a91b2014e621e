// The expression that selects atoms, as the user types it. Plain data.
#pragma once

#include <string>

namespace alphascope {

struct ExpressionState {
  std::string typed;
  bool entered = false;  // the user entered it, and no answer is shown yet
  std::string shown;     // expression in force when `typed` was last taken from it
};

}  // namespace alphascope
