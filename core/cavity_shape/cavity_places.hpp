// SPDX-License-Identifier: GPL-3.0-or-later
// The places of a cavity and of its mouths that are farthest from all balls. They can be ends of
// channels.
#pragma once

#include "core/geometry/real_point.hpp"

namespace alphascope {

class Clearance;
struct Cavity;
struct CavityGround;
struct Mouth;

struct WidestPlace {
  RealPoint place_angstrom;
  double clearance_angstrom = 0;  // negative: the place is within a ball
};

// `clearance` must be of the balls without a solvent radius. The cavity may be of any radii and
// alpha.

// A local maximum of clearance near the orthocentre of a sink. If the cavity has several chambers,
// that of the widest.
WidestPlace widest_place(const CavityGround& ground, const Cavity& cavity,
                         const Clearance& clearance);

// The widest place on the mouth's triangles, to about 0.01 Å.
WidestPlace widest_place(const CavityGround& ground, const Mouth& mouth,
                         const Clearance& clearance);

}  // namespace alphascope
