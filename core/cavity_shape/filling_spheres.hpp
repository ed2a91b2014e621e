// SPDX-License-Identifier: GPL-3.0-or-later
// A cast of a cavity: spheres that fill it and touch the atoms around it.
#pragma once

#include <span>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

class Clearance;

struct FillingSphere {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
  std::uint32_t tetrahedron = 0;  // the tetrahedron whose orthocentre is the centre
  friend bool operator==(const FillingSphere&, const FillingSphere&) = default;
};

// The largest number of spheres. If there are more, spheres of similar size in the same small cube
// are reduced to the largest one. So a cast becomes coarser everywhere, and no part of the cavity
// goes missing. If that does not suffice, only the largest spheres are kept.
inline constexpr std::size_t kMostFillingSpheres = 4000;

// Spheres around orthocentres of the cavity's tetrahedra. The centres are rounded to the lattice
// and lie in one of these tetrahedra, decided exactly. Each radius is the clearance there, min |x -
// c| - r over all balls. These have no solvent radius; `clearance` must be of such balls. So no
// sphere cuts into a ball. At alpha >= 0 no sphere is smaller than the solvent radius. Spheres are
// ordered by falling radius, then by place. At alpha < 0 the balls can cover a cavity, which then
// has no spheres. Works in the caller's task arena; the result does not depend on the number of
// threads. Throws Cancelled.
std::vector<FillingSphere> filling_spheres(const CavityGround& ground, const Cavity& cavity,
                                           const Clearance& clearance,
                                           std::size_t most = kMostFillingSpheres,
                                           const CancelToken& cancel = {});

}  // namespace alphascope
