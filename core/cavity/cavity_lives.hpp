// SPDX-License-Identifier: GPL-3.0-or-later
// The interval of alpha in which each cavity exists, for all alphas at once. A cavity is identified
// by its deepest sink. As alpha grows, cavities split and shrink and never join. So each sink is
// the deepest of a cavity in at most one interval of alpha.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cavity/cavities.hpp"

namespace alphascope {

// Square lattice units, rounded like the alpha values of which these are copies. The cavity exists
// where born <= alpha < gone. It is a void from `closed` on, and a pocket before. If `closed` >=
// `gone` it is never a void. `born` may be minus infinity.
struct CavityLife {
  float born = 0;    // where it parts from a cavity with a deeper sink
  float closed = 0;  // where its last mouth closes, or it parts from a void with a deeper sink
  float gone = 0;    // where its sink is filled
  friend bool operator==(const CavityLife&, const CavityLife&) = default;
};

struct CavityLives {
  std::vector<std::uint32_t> sinks;  // tetrahedra; ascending
  std::vector<CavityLife> lives;     // one for each sink
  // For each sink its rank among all sinks by their centres. It does not depend on the order of the
  // balls.
  std::vector<std::uint32_t> places;

  // Takes Cavity::deepest_sink. Throws std::invalid_argument if that is no sink.
  const CavityLife& of(std::uint32_t sink) const;
};

// Works in the caller's task arena; the result does not depend on the number of threads. Throws
// Cancelled.
CavityLives cavity_lives(const CavityGround& ground, OutsideRule rule = OutsideRule::castp,
                         const CancelToken& cancel = {});

}  // namespace alphascope
