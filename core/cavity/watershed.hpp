// SPDX-License-Identifier: GPL-3.0-or-later
// The assignment of a network's tetrahedra to its parts.
#pragma once

#include <vector>

#include "core/cavity/network_parting.hpp"

namespace alphascope {

// Returns for each tetrahedron of cavity `index` of `found` the index of its descendant in
// parting.descendants. Triangles open in the order in which a falling alpha opens them; ties go by
// the positions of their centres. An unassigned tetrahedron joins the set to which it opens. Two
// descendants are never joined. Exact. Throws Cancelled.
std::vector<std::uint32_t> watershed(const CavityGround& ground, const Membership& membership,
                                     const Cavities& found, std::uint32_t index,
                                     const NetworkParting& parting, const CancelToken& cancel = {});

}  // namespace alphascope
