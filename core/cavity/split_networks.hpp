// SPDX-License-Identifier: GPL-3.0-or-later
// Networks listed as their parts. The parts are what the network falls into as alpha grows, but
// with its present alpha and tetrahedra. Definition: docs/algorithm.md, Networks.
#pragma once

#include "core/cavity/cavities.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope {

class TriangulationMaker;

// Replaces each network of `found` that falls apart by two or more parts. Other networks and the
// Betti numbers stay. The parts together have exactly the network's tetrahedra and triangles of
// mouths. Each part has its own deepest sink; one of them is the network's. A mouth in front of two
// parts becomes a mouth of each. A triangle between two parts is in Cavity::passages of both.
// `membership` and `rule` must be those with which `found` was made. Works in the caller's task
// arena. The result is the same for any number of threads and any order of the balls. `maker`:
// whose device helps, if there is one. Throws Cancelled.
Cavities split_networks(const CavityGround& ground, const Membership& membership, Cavities found,
                        const Alpha& alpha_angstrom2, OutsideRule rule = OutsideRule::castp,
                        const CancelToken& cancel = {}, TriangulationMaker* maker = nullptr);

}  // namespace alphascope
