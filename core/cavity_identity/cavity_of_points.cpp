// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cavity of each given point.
#include "core/cavity_identity/cavity_of_points.hpp"

#include "core/cavity/cavity_ground.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {

std::vector<std::uint32_t> cavities_at(const CavityTable& table,
                                       std::span<const LatticePlace> places,
                                       const CancelToken& cancel) {
  std::vector<std::uint32_t> cavities(places.size(), Cavities::kNone);
  if (table.size() == 0 || places.empty()) return cavities;
  const PointLocator locator(*table.ground->balls, *table.ground->triangulation);
  parallel_many(places.size(), cancel, [&](std::size_t n) {
    const std::uint32_t at = locator.find(places[n]);
    if (at != PointLocator::kOutside) cavities[n] = table.found.cavity_of_tetrahedron[at];
  });
  return cavities;
}

}  // namespace alphascope
