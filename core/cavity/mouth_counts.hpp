// SPDX-License-Identifier: GPL-3.0-or-later
// The number of mouths of a network's descendants at every alpha above its own. One pass covers all
// alphas, as in cavity_lives.hpp. It uses alpha values that are rounded to floats.
#pragma once

#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// A range of alpha in which no descendant is a network: from < alpha < to. Square lattice units,
// rounded as alpha values are. At both ends the rounding may decide otherwise.
struct RangeWithoutNetwork {
  float from = 0, to = 0;
};

// All such ranges, ascending; the last one reaches infinity. Outside of them some descendant is a
// network. Throws Cancelled.
std::vector<RangeWithoutNetwork> ranges_without_network(const CavityGround& ground,
                                                        const Filtration& filtration,
                                                        const Membership& membership,
                                                        const Cavities& found, std::uint32_t index,
                                                        const CancelToken& cancel = {});

}  // namespace alphascope
