// How many mouths the descendants of a network have at every alpha above its own: all alphas at
// once, as cavity_lives.hpp, by alpha values that are rounded to floats.
#pragma once

#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// Square lattice units, rounded as alpha values are. Wherever from < alpha < to, no descendant is a
// network; at the ends the rounding may decide otherwise.
struct QuietRange {
  float from = 0, to = 0;
};

// Ascending, the last one up to infinity; outside of them some descendant is a network. Throws
// Cancelled.
std::vector<QuietRange> ranges_without_network(const CavityGround& ground,
                                               const Filtration& filtration,
                                               const Membership& membership, const Cavities& found,
                                               std::uint32_t index, const CancelToken& cancel = {});

}  // namespace alphascope
