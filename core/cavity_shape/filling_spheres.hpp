// A cast of a cavity: spheres that fill it and touch the atoms around it.
#pragma once

#include <span>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/channel/clearance.hpp"

namespace alphascope {

struct FillingSphere {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
  std::uint32_t tetrahedron = 0;  // whose orthocentre it is around
  friend bool operator==(const FillingSphere&, const FillingSphere&) = default;
};

// Of more, some are left out that are nearly others: of those of nearly one size in small cubes the
// largest is kept. So a cast becomes coarser everywhere, and no part of the cavity goes missing.
// Where that is not enough, the largest are kept.
inline constexpr std::size_t kMostFillingSpheres = 4000;

// Around orthocentres of the cavity's tetrahedra, rounded to the lattice, that lie in one of these
// tetrahedra (exactly decided). Each radius is the clearance there, min |x - c| - r over all balls,
// with radii without a solvent: `clearance` is of such balls. So no sphere cuts into a ball; at
// alpha >= 0 none is smaller than the solvent radius. By falling radius; of equal ones by
// place. A cavity that is covered by the balls has none: possible at alpha < 0 only.
// Works in the caller's task arena; the same for any number of threads. Throws Cancelled.
std::vector<FillingSphere> filling_spheres(const CavityGround& ground, const Cavity& cavity,
                                           const Clearance& clearance,
                                           std::size_t most = kMostFillingSpheres,
                                           const CancelToken& cancel = {});

}  // namespace alphascope
