// SPDX-License-Identifier: GPL-3.0-or-later
// Atoms that a layer draws as objects, in the style of those of the molecule, such as sticks.
#pragma once

#include <cstdint>
#include <vector>

#include "core/document/settings/drawn_object.hpp"

namespace alphascope {

struct LayerObject {
  DrawnObject object;                // its `atoms` is not used
  std::vector<std::uint32_t> atoms;  // indices in Molecule::atoms, ascending
  bool in_front = false;             // sticks, in front of everything else
};

struct LayerObjects {
  std::vector<LayerObject> of;
};

}  // namespace alphascope
