// The places of a cavity and of its mouths that are farthest from all balls: ends of channels.
#pragma once

#include "core/cavity/cavities.hpp"
#include "core/channel/clearance.hpp"

namespace alphascope {

struct WidestPlace {
  RealPoint place_angstrom;
  double clearance_angstrom = 0;  // negative: within a ball
};

// `clearance` is of the balls as they are, without a solvent; the cavity of any radii and alpha.

// Beside the orthocentre of a sink: a place to which the largest sphere near by rises. Where the
// cavity has several chambers, of the widest.
WidestPlace widest_place(const CavityGround& ground, const Cavity& cavity,
                         const Clearance& clearance);

// On the triangles of the mouth, to some 0.01 Å.
WidestPlace widest_place(const CavityGround& ground, const Mouth& mouth,
                         const Clearance& clearance);

}  // namespace alphascope
