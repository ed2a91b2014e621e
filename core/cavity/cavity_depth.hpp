// How deep a pocket is.
#pragma once

#include <span>

#include "core/cavity/cavities.hpp"

namespace alphascope {

// The largest distance of the centre of a lining atom from the nearest triangle of a mouth or
// passage, Å; 0 of a void. Works in the caller's task arena; the same bits for any number of
// threads. Throws Cancelled.
double depth_angstrom(const CavityGround& ground, const Cavity& cavity,
                      std::span<const BallIndex> lining, const CancelToken& cancel = {});

}  // namespace alphascope
