// SPDX-License-Identifier: GPL-3.0-or-later
// The match of the cavities of two tables of the same atoms. cavity_identity.hpp makes it.
#pragma once

#include <cstdint>
#include <vector>

namespace alphascope {

// Indices are those of Cavities::cavities. Among equal shares that of the first sink counts as the
// larger one. Sinks are compared by their centres, in lexicographic order, at the later positions.
struct CavityMatch {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  // For each later cavity the earlier one that it shares the largest volume with. In one
  // triangulation: the one that contains its deepest sink. kNone: the cavity is new.
  std::vector<std::uint32_t> came_from;
  // For each earlier cavity the later one, likewise. kNone: the cavity is gone.
  std::vector<std::uint32_t> goes_to;

  // Returns whether the later cavity inherits the earlier one's identity, colour and selection:
  // each must be the other's match.
  bool is_same(std::uint32_t later) const {
    return came_from[later] != kNone && goes_to[came_from[later]] == later;
  }
  // The later cavities that came from an earlier one, ascending. Two or more: it has split.
  std::vector<std::uint32_t> parts(std::uint32_t earlier) const;
  // The earlier cavities that go to a later one, ascending. Two or more: they have merged.
  std::vector<std::uint32_t> sources(std::uint32_t later) const;

  friend bool operator==(const CavityMatch&, const CavityMatch&) = default;
};

}  // namespace alphascope
