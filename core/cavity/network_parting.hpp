// At which alpha a network falls apart, without a new triangulation.
#pragma once

#include <optional>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// As alpha grows, a cavity splits and shrinks: what is left of it are its descendants.
struct NetworkParting {
  // The least multiple of kNetworkStepAngstrom2 above the alpha of the network at which none of its
  // descendants is a network.
  Alpha alpha_angstrom2;
  Cavities there;                          // all cavities at that alpha
  std::vector<std::uint32_t> descendants;  // indices of there.cavities; ascending
};

// As the slider of alpha.
inline constexpr double kNetworkStepAngstrom2 = 0.01;

// Of the cavity `index` of `found`, which is a network at alpha. What decides are the cavities that
// find_cavities() finds at that alpha. None: the network does not fall apart below
// kMaxAlphaAngstrom2. Works in the caller's task arena; the same for any number of threads, and in
// whatever order the balls are listed. Throws Cancelled.
std::optional<NetworkParting> part_network(const CavityGround& ground, const Filtration& filtration,
                                           const Membership& membership, const Cavities& found,
                                           std::uint32_t index, const Alpha& alpha_angstrom2,
                                           OutsideRule rule = OutsideRule::castp,
                                           const CancelToken& cancel = {});

}  // namespace alphascope
