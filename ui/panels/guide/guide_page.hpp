// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a page of the guide: its blocks below each other, with links, and menus that copy.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace alphascope {

struct Guide;
struct GuidePlace;
struct PanelContext;

// The heights of the blocks of a page. They hold for one page, width and size of letters.
struct GuideLayout {
  const void* page = nullptr;
  float width = 0, letters = 0;
  std::vector<float> tops;                  // of each block, and the end; in pixels
  std::vector<std::vector<float>> columns;  // widths, for each row of a table
};

struct GuideView {
  std::size_t page = 0;
  std::vector<std::string> words;        // marked in the text
  std::optional<std::size_t> marked;     // the block with the hit that was followed
  std::optional<std::size_t> scroll_to;  // this block is to be at the top, or near it
  float scroll_by = 0;                   // pixels
  float scroll = 0;                      // the present place, in pixels
  std::size_t copied = 0;                // the block whose menu is open
  GuideLayout layout = {};
};

// Draws the page in a window of its own that fills the remaining room. Returns the target of a link
// that was clicked; empty: none.
std::string draw_guide_page(PanelContext& ctx, const Guide& guide, GuideView& view);

}  // namespace alphascope
