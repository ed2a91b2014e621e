// SPDX-License-Identifier: GPL-3.0-or-later
// The mouths of cavities, from the triangles through which they open.
#pragma once

#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/triangulation/grouped.hpp"

namespace alphascope {

// Group c of `opening` holds the triangles through which cavity c opens, ascending. Their own
// groups become its mouths.
void set_mouths(const CavityGround& ground, const Membership& membership, const Grouped& opening,
                std::vector<Cavity>& cavities);

}  // namespace alphascope
