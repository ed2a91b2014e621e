// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of the section “Objects” between frames. Plain data.
#pragma once

#include <string>

namespace alphascope {

struct ObjectsState {
  int open = -1;      // index of the object whose settings are shown; -1: none
  std::string typed;  // its atoms, as the user types them
  std::string shown;  // the atoms from which `typed` was last filled
  std::string error;  // of the typed text; empty: none
};

}  // namespace alphascope
