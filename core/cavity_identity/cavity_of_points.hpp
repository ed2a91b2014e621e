// Which cavity holds a point, such as the centre of an atom that is no ball.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/point_location.hpp"

namespace alphascope {

// Of each place (lattice of the ground's balls) the index of the cavity of found.cavities in whose
// tetrahedra it lies, as PointLocator decides, or Cavities::kNone. A cavity's tetrahedra reach into
// the balls around it, so a point that is nearer to an atom than its radius can be in it. Works in
// the caller's task arena; the same for any number of threads. Throws Cancelled.
std::vector<std::uint32_t> cavities_at(const CavityTable& table,
                                       std::span<const LatticePlace> places,
                                       const CancelToken& cancel = {});

}  // namespace alphascope
