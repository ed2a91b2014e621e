// The list of panels. A new one is a source of its own and one line in panel_list.cpp.
#pragma once

#include <span>

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// A section; a page below the view; a column beside the view.
enum class Place : std::uint8_t { left, bottom, right };

struct PanelSpec {
  const char* id;
  const char* title;
  Place place;
  // At the left, the panel draws its own heading; below the view, its title stands before it in the
  // first line already.
  void (*draw)(PanelContext& ctx);
  const char* also = "";  // other words for what it shows, to find it by
};

std::span<const PanelSpec> panels();  // in the order in which they are shown

}  // namespace alphascope
