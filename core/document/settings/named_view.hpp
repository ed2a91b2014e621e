// SPDX-License-Identifier: GPL-3.0-or-later
// A camera saved under a name. It is a setting, so undo and session files include it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace alphascope {

// Positions are in Å, in the coordinates of the file.
struct NamedView {
  std::string name;
  std::array<double, 3> position{0, 0, 1}, focal_point{}, up{0, 1, 0};
  // As in Viewpoint: aspect of the narrowest picture at the usual angle.
  double least_aspect = 0;
  bool orthographic = false;
  friend bool operator==(const NamedView&, const NamedView&) = default;
};

using NamedViews = std::vector<NamedView>;

}  // namespace alphascope
