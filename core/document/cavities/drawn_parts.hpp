// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of parts of selected cavities that the picture shows.
#pragma once

namespace alphascope {

// The parts of selected cavities that are drawn.
struct DrawnCavityParts {
  bool surfaces = true, tetrahedra = false, spheres = false, rims = true, numbers = false;
  friend bool operator==(const DrawnCavityParts&, const DrawnCavityParts&) = default;
};

}  // namespace alphascope
