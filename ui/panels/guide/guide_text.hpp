// SPDX-License-Identifier: GPL-3.0-or-later
// Draws blocks of the guide: headings, paragraphs, items, code, rows of tables, pictures.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/document/guide/markdown.hpp"

namespace alphascope {

struct PanelContext;

// Code leaves room at its right for a button that copies it, in pixels at scale 1.
inline constexpr float kCopyButtonWidth = 52;

// A link on the screen, for the caller to make a button of it. A link on two lines is two of them.
struct ShownLink {
  std::string target;
  ImVec2 low, high;
};

struct GuideLook {
  bool draws = true;                                // false: measures only
  const std::vector<std::string>* words = nullptr;  // marked in the text; null: none
  std::vector<ShownLink>* links = nullptr;          // gets the links; null: none are wanted
};

// Draws or measures a block at `corner`, and returns its height in pixels with the gap below it. A
// row needs the widths of its table's columns.
float put_guide_block(PanelContext& ctx, const MarkdownBlock& block, ImVec2 corner, float width,
                      const std::vector<float>& columns, const GuideLook& look);

// The widths of columns in pixels, with their padding, for the rows [begin, end) of a table.
std::vector<float> guide_columns(PanelContext& ctx, const std::vector<MarkdownBlock>& blocks,
                                 std::size_t begin, std::size_t end, float width);

}  // namespace alphascope
