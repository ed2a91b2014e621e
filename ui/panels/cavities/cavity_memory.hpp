// What other panels may know of the page of cavities. Plain data.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/document/reference/reference.hpp"

namespace alphascope {

struct CavityPage;  // cavity_page.hpp

struct CavityMemory {
  // Of what is chosen (Selection::cavities), the deepest sinks that those cavities have in the
  // table on screen; the one that was clicked last comes last.
  std::vector<SimplexRef> chosen;
  std::optional<std::size_t> wanted_row;  // to be chosen, from 0, as soon as the table is there
  std::shared_ptr<CavityPage> page;       // null until it is first drawn
};

}  // namespace alphascope
