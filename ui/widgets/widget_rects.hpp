// SPDX-License-Identifier: GPL-3.0-or-later
// Rectangles of all named widgets in the last frame, in pixels. Plain data.
#pragma once

#include <map>
#include <string>

namespace alphascope {

struct WidgetRect {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool visible = true;  // false: its middle is scrolled out of sight
};

using WidgetRects = std::map<std::string, WidgetRect>;

}  // namespace alphascope
