// SPDX-License-Identifier: GPL-3.0-or-later
// A sentence for names that have changed. A former name is read for one more version.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

// "is called "request" now. …", to follow the former name.
inline std::string is_called_now(std::string_view name) {
  return "is called \"" + std::string(name) +
         "\" now. The older name is still read in this version.";
}

}  // namespace alphascope
