// What the menu of the right mouse button is about. Plain data.
#pragma once

#include <optional>
#include <string>

#include "core/document/reference/reference.hpp"

namespace alphascope {

struct ContextMemory {
  bool opens = false;       // with the next frame
  bool open = false;        // in the last frame
  std::optional<Ref> what;  // none: the mouse was beside everything
  std::string title;        // of it: "A:HIS 87:NE2"
};

}  // namespace alphascope
