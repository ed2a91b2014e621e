// The tetrahedra of a network, given to its parts.
#pragma once

#include <vector>

#include "core/cavity/network_parting.hpp"

namespace alphascope {

// Of each tetrahedron of cavity `index` of `found` the index of its descendant in
// parting.descendants. The faces open in the order in which a falling alpha opens them, of equal
// ones by the places of their centres; what belongs to nobody yet joins what it opens to, and two
// descendants stay two. Exact. Throws Cancelled.
std::vector<std::uint32_t> watershed(const CavityGround& ground, const Membership& membership,
                                     const Cavities& found, std::uint32_t index,
                                     const NetworkParting& parting, const CancelToken& cancel = {});

}  // namespace alphascope
