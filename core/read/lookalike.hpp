// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises files that are not molecules in our formats but that people take for one, or keep
// beside one.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

struct Lookalike {
  std::string what;      // completes "it looks like …"
  std::string remedy;    // without full stop; empty: use a format of ours
  bool certain = false;  // by a mark of that format alone, whatever the name
};

Lookalike find_lookalike(std::string_view text);

}  // namespace alphascope
