// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha at which a network falls apart, found without a new triangulation.
#pragma once

#include <optional>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// As alpha grows, a cavity shrinks and splits. The cavities that lie in it at a larger alpha are
// its descendants there.
struct NetworkParting {
  // The least multiple of kNetworkStepAngstrom2 above the network's alpha at which no descendant is
  // a network.
  Alpha alpha_angstrom2;
  Cavities there;                          // all cavities at that alpha
  std::vector<std::uint32_t> descendants;  // indices of there.cavities; ascending
};

// The step of the alphas that are tried (Å²).
inline constexpr double kNetworkStepAngstrom2 = 0.01;

// Finds the alpha at which cavity `index` of `found`, a network at `alpha`, falls apart. The
// cavities that find_cavities() finds at larger alphas decide. Returns nothing if the network does
// not fall apart below kMaxAlphaAngstrom2. Works in the caller's task arena. The result is the same
// for any number of threads and any order of the balls. Throws Cancelled.
std::optional<NetworkParting> part_network(const CavityGround& ground, const Filtration& filtration,
                                           const Membership& membership, const Cavities& found,
                                           std::uint32_t index, const Alpha& alpha_angstrom2,
                                           OutsideRule rule = OutsideRule::castp,
                                           const CancelToken& cancel = {});

}  // namespace alphascope
