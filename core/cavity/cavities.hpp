// SPDX-License-Identifier: GPL-3.0-or-later
// The voids and pockets of K_alpha: the tetrahedra of which they consist, and the mouths through
// which they open. Definitions: docs/algorithm.md, Cavities.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct CavityGround;
struct Membership;

// The rule for an empty tetrahedron from which some ways of the flow (core/triangulation/flow.hpp)
// end at infinity and others at a sink.
enum class OutsideRule {
  castp,  // outside iff all ways end at infinity
  pocket  // outside iff at least one way ends at infinity
};

// Triangles not in K_alpha through which a pocket opens. They are joined at shared edges and
// vertices that are not in K_alpha. Ascending indices of Incidence::triangles.
struct Mouth {
  std::vector<std::uint32_t> triangles;
  friend bool operator==(const Mouth&, const Mouth&) = default;
};

// Indices refer to the ground's lists and to the balls. All lists are ascending.
struct Cavity {
  static constexpr std::uint32_t kWhole = ~std::uint32_t{0};

  std::vector<std::uint32_t> tetrahedra;
  std::vector<Mouth> mouths;     // ordered by their first triangles
  std::vector<BallIndex> atoms;  // vertices of the tetrahedra that are in K_alpha
  // The number of components of K_alpha to which those atoms belong. Above 1: the cavity lies
  // between bodies.
  std::uint32_t bodies = 0;
  std::uint32_t sinks = 0;
  // The sink of largest ortho-radius; of equal ones the first by the positions of its centres. It
  // identifies the cavity while alpha changes.
  std::uint32_t deepest_sink = 0;
  // For a part of a network (split_networks.hpp): its index in Cavities::networks; else kWhole.
  // `passages` are the triangles not in K_alpha between it and other parts, joined as those of
  // mouths.
  std::uint32_t network = kWhole;
  std::vector<Mouth> passages;

  // A pocket with at least this many mouths is a network of connected gaps rather than one hole. A
  // symmetric hollow shell has fewer mouths and is no network: a cage of 24 equal parts opens at
  // its eight threefold and six fourfold axes, so it has 14.
  static constexpr std::size_t kMouthsOfNetwork = 20;

  // A part without mouths can be open to other parts, and is no void then.
  bool is_void() const { return mouths.empty() && passages.empty(); }
  bool is_part() const { return network != kWhole; }
  bool is_network() const { return !is_part() && mouths.size() >= kMouthsOfNetwork; }
  std::size_t mouth_triangles() const;
  friend bool operator==(const Cavity&, const Cavity&) = default;
};

// A network that is listed as its parts.
struct SplitNetwork {
  std::uint32_t deepest_sink = 0;  // also the deepest sink of one of the parts
  std::size_t mouths = 0, tetrahedra = 0, parts = 0;
  Alpha falls_apart_angstrom2;  // NetworkParting::alpha_angstrom2
  friend bool operator==(const SplitNetwork&, const SplitNetwork&) = default;
};

struct Cavities {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<Cavity> cavities;  // ordered by their first tetrahedra
  // For each tetrahedron the index of its cavity, or kNone.
  ResultArray<std::uint32_t> cavity_of_tetrahedron;
  std::array<std::size_t, 4> simplices{};  // counts of K_alpha's simplices, by dimension
  // Connected components, tunnels and voids of K_alpha. If there are several components, spaces
  // between bodies count as pockets.
  long long components = 0, tunnels = 0, voids = 0;
  std::vector<SplitNetwork> networks;  // filled by split_networks()

  friend bool operator==(const Cavities&, const Cavities&) = default;
};

// Finds the cavities of the K_alpha that `membership` describes. Works in the caller's task arena;
// the result does not depend on the number of threads. Throws Cancelled, and InternalError if
// something contradicts the definitions.
Cavities find_cavities(const CavityGround& ground, const Membership& membership,
                       OutsideRule rule = OutsideRule::castp, const CancelToken& cancel = {});

}  // namespace alphascope
