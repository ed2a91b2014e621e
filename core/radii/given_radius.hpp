// Radii as sets, tables and users give them, in 10^-6 Å, on the lattice of the balls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

// In units of the lattice, at least 1, and by how much it was changed where the lattice does not
// hold it.
struct LatticeRadius {
  std::int32_t units;
  double rounding_angstrom;
};
LatticeRadius on_lattice(std::int32_t microangstrom, const Lattice& lattice);

// A ball whose given radius its lattice does not hold.
struct RoundedBall {
  BallIndex ball;
  std::int32_t microangstrom;
};

struct RadiusRounding {
  std::size_t balls = 0;
  double largest_angstrom = 0;
};

// Puts the balls on the coarsest lattice that holds all given radii, or on the finest that the
// bounds leave room for; tells what is rounded even there.
RadiusRounding fit_lattice(BallSet& balls, const std::vector<RoundedBall>& rounded);

}  // namespace alphascope
