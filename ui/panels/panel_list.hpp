// The list of panels. A new one is a source of its own and one line in panel_list.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "ui/panels/panel.hpp"

namespace alphascope {

// A section; a page below the view; a column beside the view.
enum class Place : std::uint8_t { left, bottom, right };

struct PanelSpec {
  const char* id;
  const char* title;
  Place place;
  // At the left, the panel draws its own heading; below the view, its title stands before it in the
  // first line already.
  std::unique_ptr<Panel> (*make)();
  const char* also = "";  // other words for what it shows, to find it by
};

std::span<const PanelSpec> panels();  // in the order in which they are shown

// One panel of each, with what it remembers.
class PanelSet {
 public:
  PanelSet();
  Panel& of(const PanelSpec& spec) { return of(std::string_view(spec.id)); }
  Panel& of(std::string_view id);  // that panels() has

 private:
  std::vector<std::unique_ptr<Panel>> panels_;  // as panels()
};

}  // namespace alphascope
