// SPDX-License-Identifier: GPL-3.0-or-later
// The cavities of all tables that were followed while the solvent radius moved. Each table leaves a
// point at its radius, so curves appear without any computation of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/cavity/cavity_table.hpp"

namespace alphascope {

struct CavityNumbers;

struct TracedCavity {
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  std::uint32_t number = 0;  // of CavityNumbers
  std::uint32_t mouths = 0;
};

struct TracedTotals {
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  std::size_t mouths = 0;
};

// The values of one table at its solvent radius, exactly as the table has them.
struct TracedPoint {
  double solvent_radius_angstrom = 0;
  std::vector<TracedCavity> cavities;  // numbers ascend
  TracedTotals voids, pockets;         // summed in the order of found.cavities, as curves are

  // The cavity with a number; null if there is none.
  const TracedCavity* find(std::uint32_t number) const;
};

// The most that a trace keeps. The slider has 501 radii. A cavity takes 24 bytes, so a trace takes
// at most 24 MB and its newest point.
struct TraceLimits {
  std::size_t points = 501, cavities = 1'000'000;
};

// All points are of the same atoms and of the same question, apart from the radius. Their numbers
// continue each other.
struct CavityTrace {
  CavityParameters question;                               // of the newest point
  std::vector<std::shared_ptr<const TracedPoint>> points;  // radii ascend, all different
};

// Adds the table of `numbers` to the trace `before`. A point of the same radius is replaced. The
// trace begins anew without `before`, where numbers begin anew (CavityNumbers::steps is 0), and for
// another question. Beyond the limits, the points whose neighbours lie closest together leave
// first. The ends leave last, and the newest point stays.
std::shared_ptr<const CavityTrace> next_trace(const CavityTrace* before,
                                              const CavityNumbers& numbers,
                                              const TraceLimits& limits = {});

std::uint64_t bytes_of(const CavityTrace& trace);

}  // namespace alphascope
