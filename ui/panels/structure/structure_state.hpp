// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of the page Structure between frames. Plain data.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace alphascope {

struct FoundWays;
struct Layer;
struct StructureRows;

struct StructureState {
  std::shared_ptr<const StructureRows> of;  // the rows that the indices below are of
  std::set<std::string> open;               // titles of branches whose residues are shown
  std::shared_ptr<const FoundWays> ways;    // channels; null until they are found
  std::string ways_problem;                 // why there are none
  // Numbers of ways, from 1: chosen by a click, and under the mouse in the last frame. 0: none.
  std::size_t way = 0, hovered_way = 0;
  std::size_t anchor = static_cast<std::size_t>(-1);  // row clicked last; Shift reaches from it
  std::optional<std::size_t> hovered;   // row under the mouse on the page, in the last frame
  std::optional<std::size_t> scrolled;  // row that the tree was scrolled to
  std::optional<std::size_t> marked;    // row of `mark`
  std::shared_ptr<const Layer> mark;    // of the row under the mouse
};

}  // namespace alphascope
