// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the cavity page's state that other panels may see. Plain data.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/document/reference/ref_set.hpp"

namespace alphascope {

struct CavityPage;  // cavity_page.hpp

struct CavityState {
  // The deepest sinks of the chosen cavities (Selection::cavities), as the table on screen has
  // them. The sink of the cavity clicked last comes last.
  std::vector<SimplexRef> chosen;
  // Row to be chosen as soon as there is a table, counted from 0.
  std::optional<std::size_t> wanted_row;
  // Row of the cavity whose body is under the mouse in the picture, as the picture has it.
  std::optional<std::size_t> under_mouse;
  std::shared_ptr<CavityPage> page;  // null until the page is drawn first
};

// Drops the table, the chosen cavities and their drawings. Filter, columns and drawn parts stay.
void forget_cavities(CavityState& state);

}  // namespace alphascope
