// SPDX-License-Identifier: GPL-3.0-or-later
// The cavity that contains a point, such as the centre of an atom that is no ball.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/point_location.hpp"

namespace alphascope {

// Returns for each place (on the lattice of the ground's balls) an index in found.cavities, or
// Cavities::kNone. PointLocator decides whose tetrahedra contain the place. A cavity's tetrahedra
// reach into the balls around it. So a point within the radius of an atom can be in a cavity. Works
// in the caller's task arena; the result does not depend on the number of threads. Throws
// Cancelled.
std::vector<std::uint32_t> cavities_at(const CavityTable& table,
                                       std::span<const LatticePlace> places,
                                       const CancelToken& cancel = {});

}  // namespace alphascope
