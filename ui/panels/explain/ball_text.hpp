// An atom's place and radius in words.
#pragma once

#include <string>

#include "core/document/settings/request.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// "12.345, 6.789, 0.123": Å, as many digits as the lattice has, up to four.
std::string place_text(const LatticePoint& point, const Lattice& lattice);

// "radius 1.64 Å, grown 2.02 Å"; without `shown`, which is what a complex was asked for with, the
// grown radius is not known. `balls` have their own radii, before any solvent.
std::string radius_text(const BallSet& balls, const Request* shown, BallIndex ball);

}  // namespace alphascope
