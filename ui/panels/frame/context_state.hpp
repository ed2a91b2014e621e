// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the context menu, which the right mouse button opens. Plain data.
#pragma once

#include <optional>
#include <string>

#include "core/document/reference/ref_set.hpp"

namespace alphascope {

struct ContextState {
  bool opens = false;       // with the next frame
  bool open = false;        // in the last frame
  std::optional<Ref> what;  // the thing it is about; none: no thing was under the mouse
  std::string title;        // name of that thing: "A:HIS 87:NE2"
  // An expression, if the menu is about all its atoms; `what` is then one of them. Else empty.
  std::string atoms;
};

}  // namespace alphascope
