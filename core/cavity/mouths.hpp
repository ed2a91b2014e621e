// SPDX-License-Identifier: GPL-3.0-or-later
// The mouths of cavities, from the triangles through which they open.
#pragma once

#include <vector>

#include "core/cavity/cavities.hpp"

namespace alphascope {

// `opening[c]` holds the triangles through which cavity c opens, ascending. Their groups become its
// mouths.
void set_mouths(const CavityGround& ground, const Membership& membership,
                const std::vector<std::vector<std::uint32_t>>& opening,
                std::vector<Cavity>& cavities);

}  // namespace alphascope
