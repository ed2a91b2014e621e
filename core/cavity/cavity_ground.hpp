// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a search for cavities that does not depend on alpha: incidences and flow of the
// triangulation.
#pragma once

#include <memory>

#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"

namespace alphascope {

struct BallSet;
struct RunContext;
struct Triangulation;
class TriangulationMaker;

// Below dimension 3 there are no cavities, and incidence and flow are empty.
struct CavityGround {
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<const Triangulation> triangulation;
  Incidence incidence;
  Flow flow;
};

// Works in the caller's task arena. `maker`: whose device makes it, if there is one. Throws
// Cancelled.
CavityGround make_cavity_ground(std::shared_ptr<const BallSet> balls,
                                std::shared_ptr<const Triangulation> triangulation,
                                FlowTies ties = FlowTies::perturbed, const RunContext& context = {},
                                TriangulationMaker* maker = nullptr);

}  // namespace alphascope
