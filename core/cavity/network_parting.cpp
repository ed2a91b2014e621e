// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the alpha at which a network falls apart: tries multiples of a step in the ranges where
// counts of mouths, with rounded alpha values, show no network.
#include "core/cavity/network_parting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/mouth_counts.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/triangulation/membership.hpp"

namespace alphascope {
namespace {

// The cavities at a larger alpha whose tetrahedra belong to cavity `index` of `found`.
std::vector<std::uint32_t> descendants_of(const Cavities& found, std::uint32_t index,
                                          const Cavities& there) {
  std::vector<std::uint32_t> descendants;
  for (std::uint32_t c = 0; c < there.cavities.size(); ++c) {
    if (found.cavity_of_tetrahedron[there.cavities[c].deepest_sink] == index) {
      descendants.push_back(c);
    }
  }
  return descendants;
}

constexpr double kStepsPerSquareAngstrom = 1 / kNetworkStepAngstrom2;

Alpha alpha_of(double step) {
  return Alpha(step / kStepsPerSquareAngstrom);
}

}  // namespace

std::optional<NetworkParting> part_network(const CavityGround& ground, const Filtration& filtration,
                                           const Membership& in, const Cavities& found,
                                           std::uint32_t index, const Alpha& alpha,
                                           OutsideRule rule, const CancelToken& cancel) {
  const Lattice& lattice = ground.balls->lattice;
  double step = std::floor(alpha.nearest() * kStepsPerSquareAngstrom);
  while (alpha_of(step) <= alpha) ++step;
  for (const RangeWithoutNetwork& range :
       ranges_without_network(ground, filtration, in, found, index, cancel)) {
    // Begins one step before, because square_angstrom() rounds.
    step = std::max(step,
                    std::floor(lattice.square_angstrom(range.from) * kStepsPerSquareAngstrom) - 1);
    for (; is_valid_alpha(alpha_of(step)); ++step) {
      cancel.throw_if_cancelled();
      NetworkParting parting{alpha_of(step), {}, {}};
      const LatticeAlpha limit = lattice.alpha_on_lattice(parting.alpha_angstrom2);
      if (limit.nearest_float() < range.from) continue;
      if (limit.nearest_float() > range.to) break;
      parting.there = find_cavities(ground, membership(filtration, limit), rule, cancel);
      parting.descendants = descendants_of(found, index, parting.there);
      const bool none =
          std::none_of(parting.descendants.begin(), parting.descendants.end(),
                       [&](std::uint32_t c) { return parting.there.cavities[c].is_network(); });
      if (none) return parting;
    }
  }
  return {};
}

}  // namespace alphascope
