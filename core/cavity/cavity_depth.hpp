// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of a pocket: how far its lining is from its mouths.
#pragma once

#include <span>

#include "core/cavity/cavities.hpp"

namespace alphascope {

// The largest distance (Å) of a lining atom's centre from the nearest triangle of a mouth or
// passage. It is 0 for a void. Works in the caller's task arena; the same bits for any number of
// threads. Throws Cancelled.
double depth_angstrom(const CavityGround& ground, const Cavity& cavity,
                      std::span<const BallIndex> lining, const CancelToken& cancel = {});

}  // namespace alphascope
