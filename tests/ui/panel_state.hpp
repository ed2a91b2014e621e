// SPDX-License-Identifier: GPL-3.0-or-later
// What a panel remembers, for tests.
#pragma once

#include <string_view>

#include "ui/panels/panel_list.hpp"

namespace alphascope::testing {

// Throws std::bad_cast for a panel that remembers something else.
template <class Memory>
Memory& memory_of(PanelSet& panels, std::string_view id) {
  return dynamic_cast<RememberingPanel<Memory>&>(panels.of(id)).memory();
}

}  // namespace alphascope::testing
