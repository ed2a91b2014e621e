// Which cavity of one table is which of another one of the same atoms.
//
// In one triangulation, at two alphas, a cavity is known by its deepest sink. With another solvent
// radius, or atoms in other places, the triangulations differ, and the volume that two cavities
// share decides: that of the tetrahedra of the later one whose centroids lie in the earlier one. A
// tetrahedron of the same four balls in both counts as a whole. The volumes are whole numbers on
// the lattice, so no rounding decides.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cavity/cavity_table.hpp"

namespace alphascope {

// Indices are those of Cavities::cavities. Of equal shares the cavity of the sink that comes first
// counts as the larger one, in lexicographic order of its centres where they are later.
struct CavityMatch {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  // Of each later cavity the earlier one that it shares most with, in one triangulation the one
  // that its deepest sink is in; kNone: it is new.
  std::vector<std::uint32_t> came_from;
  // Of each earlier cavity the later one, likewise; kNone: it is gone.
  std::vector<std::uint32_t> goes_to;

  // Does the later one carry on the earlier one's identity, colour, selection? Each is
  // what the other one names.
  bool is_same(std::uint32_t later) const {
    return came_from[later] != kNone && goes_to[came_from[later]] == later;
  }
  // The later cavities that came from an earlier one, ascending: two or more, and it has split.
  std::vector<std::uint32_t> parts(std::uint32_t earlier) const;
  // The earlier cavities that go to a later one, ascending: two or more, and they have merged.
  std::vector<std::uint32_t> sources(std::uint32_t later) const;

  friend bool operator==(const CavityMatch&, const CavityMatch&) = default;
};

// Both of balls with the same indices, else std::invalid_argument. Works in the caller's task
// arena; the same for any number of threads. Throws Cancelled.
CavityMatch match_cavities(const CavityTable& earlier, const CavityTable& later,
                           const CancelToken& cancel = {});

// What of a table is needed to match it later, without its triangulation.
struct CavityRegions {
  Simplices<4> tetrahedra;                      // of all cavities, in lexicographic order
  std::vector<std::uint32_t> cavity;            // of each tetrahedron
  std::vector<std::array<BallIndex, 4>> sinks;  // of each cavity, its deepest
};
CavityRegions regions_of(const CavityTable& table);

// By tetrahedra of the same four balls alone. `balls`: where they are later.
CavityMatch match_regions(const CavityRegions& earlier, const CavityRegions& later,
                          const BallSet& balls);

}  // namespace alphascope
