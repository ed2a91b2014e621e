// SPDX-License-Identifier: GPL-3.0-or-later
// The list of panels. A new panel is a source of its own and one line in panel_list.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "ui/panels/panel.hpp"

namespace alphascope {

// The place of a panel: a section at the left, a page below the view, a column beside the view, or
// a window of its own over them.
enum class PanelPlace : std::uint8_t { left, bottom, right, over };

struct PanelSpec {
  const char* id;
  const char* title;
  PanelPlace place;
  // A section draws its own heading. A page does not, since the window draws the names of the
  // pages.
  std::unique_ptr<Panel> (*make)();
  const char* also = "";  // other words by which people find it
};

// The section at the left that does not scroll, so that it is never out of sight.
inline constexpr const char* kPinnedSection = "alpha";

std::span<const PanelSpec> panels();  // in the order shown

// One object of each panel, with what it remembers.
class PanelSet {
 public:
  PanelSet();
  Panel& of(const PanelSpec& spec) { return of(std::string_view(spec.id)); }
  Panel& of(std::string_view id);                           // throws if panels() has no such id
  void add_commands(Commands& commands, ViewState& state);  // adds the commands of all panels

 private:
  std::vector<std::unique_ptr<Panel>> panels_;  // in the order of panels()
};

}  // namespace alphascope
