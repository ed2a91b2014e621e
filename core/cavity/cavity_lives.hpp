// From which alpha to which each cavity is there, for all alphas at once. A cavity is known by its
// deepest sink; as alpha grows, cavities split and shrink and never join, so each sink is the
// deepest of one cavity during one interval of alpha at most.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cavity/cavities.hpp"

namespace alphascope {

// Square lattice units, rounded like the alpha values of which they are copies; born may be minus
// infinity. The cavity is there where born <= alpha < gone: a pocket first, a void from `closed` on
// (never, where that is not below `gone`).
struct CavityLife {
  float born = 0;    // it parts from a cavity of a deeper sink
  float closed = 0;  // its last mouth closes, or it parts from a void of a deeper sink
  float gone = 0;    // its sink is filled
  friend bool operator==(const CavityLife&, const CavityLife&) = default;
};

struct CavityLives {
  std::vector<std::uint32_t> sinks;  // tetrahedra; ascending
  std::vector<CavityLife> lives;     // of each sink
  // Of each sink its place among all of them by their centres, which is the same in whatever order
  // the balls are listed.
  std::vector<std::uint32_t> places;

  // Of what Cavity::deepest_sink says.
  const CavityLife& of(std::uint32_t sink) const;
};

// Works in the caller's task arena; the same for any number of threads. Throws Cancelled.
CavityLives cavity_lives(const CavityGround& ground, OutsideRule rule = OutsideRule::castp,
                         const CancelToken& cancel = {});

}  // namespace alphascope
