// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for an atom's position and radius.
#pragma once

#include <string>

#include "core/geometry/ball_index.hpp"

namespace alphascope {

struct BallSet;
struct Lattice;
struct LatticePoint;
struct Request;

// Returns "12.345, 6.789, 0.123", in Å. It has as many decimals as the lattice, up to four.
std::string place_text(const LatticePoint& point, const Lattice& lattice);

// Returns "radius 1.64 Å, grown 2.02 Å". `shown` is the request of the complex on screen; without
// it there is no grown radius. `balls` have radii without solvent.
std::string radius_text(const BallSet& balls, const Request* shown, BallIndex ball);

}  // namespace alphascope
