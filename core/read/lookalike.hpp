// What a file is that is no molecule we can read: the formats that people mistake for one, or keep
// beside one.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

struct Lookalike {
  std::string what;      // completes "it looks like …"
  std::string remedy;    // without full stop; empty when nothing better is known than our formats
  bool certain = false;  // its own mark was found: whatever its name, it is this
};

Lookalike look_at(std::string_view text);

}  // namespace alphascope
