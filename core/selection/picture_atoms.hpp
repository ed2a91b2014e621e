// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of atoms in the picture that words of an expression mean.
#pragma once

#include <vector>

namespace alphascope {

// The atoms for "selected" and "hidden": one value for each atom of the molecule. Null: there is no
// picture, and the word is refused.
struct PictureAtoms {
  const std::vector<bool>* selected = nullptr;
  const std::vector<bool>* hidden = nullptr;
};

}  // namespace alphascope
