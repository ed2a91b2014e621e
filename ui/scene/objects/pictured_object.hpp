// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a picture.
#pragma once

#include <memory>
#include <vector>

namespace alphascope {

struct ObjectMesh;

struct PicturedObject {
  std::shared_ptr<const ObjectMesh> mesh;
  float opacity = 1;      // above 0, at most 1
  bool in_front = false;  // its sticks are drawn in front of everything else
};
using PicturedObjects = std::vector<PicturedObject>;

}  // namespace alphascope
