// SPDX-License-Identifier: GPL-3.0-or-later
// Breaks text of several fonts into lines. ImGui wraps text of one font only.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

namespace alphascope {

// A piece of a text in one font. Blanks are in the text, so a word may go on in the next span. A
// line end breaks the line.
struct FlowSpan {
  std::string_view text;
  const ImFont* font = nullptr;
  float size = 1;     // factor on the font's size
  float padding = 0;  // room before and behind the span, in pixels
};

// The place of a text on the screen, in pixels. `line` is the height of a line. The letters of all
// fonts stand on the baseline of `base`.
struct FlowArea {
  ImVec2 corner;
  float width = 0, line = 0;
  const ImFont* base = nullptr;
};

// A part of a span on one line. `gap` is the width of the blank before it, if the span was there
// already.
struct FlowPiece {
  std::size_t span = 0;
  std::string_view text;
  ImVec2 low, high;    // the whole height of the line
  float baseline = 0;  // y
  float gap = 0;
};

// Calls use(piece) for all pieces in turn. Returns the height of the text, in pixels. A word wider
// than the area is broken behind | or /, or between two letters. A number keeps its unit Å.
float flow_text(std::span<const FlowSpan> spans, const FlowArea& area,
                const std::function<void(const FlowPiece&)>& use = {});

// Widths in pixels: of the text without a break but at its line ends, and of its widest word.
struct FlowWidths {
  float natural = 0, least = 0;
};
FlowWidths flow_widths(std::span<const FlowSpan> spans);

}  // namespace alphascope
