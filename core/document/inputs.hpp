// What derived results are made of. Each uses a part of it.
#pragma once

#include <cstdint>
#include <memory>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

struct Inputs {
  std::shared_ptr<const BallSet> balls;  // with the solvent radius; null: no molecule
  std::uint64_t balls_key = 0;           // another number for other balls; 0: none
  // Of these balls; null as long as they are not made.
  std::shared_ptr<const Triangulation> triangulation;
  std::shared_ptr<const Filtration> filtration;
  double alpha_angstrom2 = 0;  // of the complex on screen
};

}  // namespace alphascope
