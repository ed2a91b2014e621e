// A camera that was saved under a name. A setting: undo, and a session file, know it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace alphascope {

// Places in Å, in the coordinates of the file.
struct NamedView {
  std::string name;
  std::array<double, 3> position{0, 0, 1}, focal_point{}, up{0, 1, 0};
  // As in Viewpoint: what a picture that is narrower must still show.
  double least_aspect = 0;
  bool orthographic = false;
  friend bool operator==(const NamedView&, const NamedView&) = default;
};

using NamedViews = std::vector<NamedView>;

}  // namespace alphascope
