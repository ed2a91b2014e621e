// The voids and pockets of K_alpha: which tetrahedra of the triangulation they are made of, and
// through which mouths they open. Definitions: docs/algorithm.md, Cavities.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/alpha.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/membership.hpp"

namespace alphascope {

// Which empty tetrahedra lie outside, of those from which some ways of the flow end at infinity and
// some at a sink.
enum class OutsideRule {
  castp,  // outside iff every way ends at infinity
  pocket  // outside iff some way does
};

// What the cavities of one set of balls have in common at every alpha. Below dimension 3 there are
// no cavities, and incidence and flow are empty.
struct CavityGround {
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<const Triangulation> triangulation;
  Incidence incidence;
  Flow flow;
};

// Works in the caller's task arena. Throws Cancelled.
CavityGround make_cavity_ground(std::shared_ptr<const BallSet> balls,
                                std::shared_ptr<const Triangulation> triangulation,
                                FlowTies ties = FlowTies::perturbed,
                                const RunContext& context = {});

// Triangles not in K_alpha through which a pocket opens, joined where they share an edge or a
// vertex that is not in K_alpha. Ascending indices of Incidence::triangles.
struct Mouth {
  std::vector<std::uint32_t> triangles;
  friend bool operator==(const Mouth&, const Mouth&) = default;
};

// Indices are those of the ground's lists and of the balls; all lists ascend.
struct Cavity {
  static constexpr std::uint32_t kWhole = ~std::uint32_t{0};

  std::vector<std::uint32_t> tetrahedra;
  std::vector<Mouth> mouths;     // by their first triangles
  std::vector<BallIndex> atoms;  // the vertices of the tetrahedra that are in K_alpha
  // To how many components of K_alpha those atoms belong: more than one where it lies between
  // bodies.
  std::uint32_t bodies = 0;
  std::uint32_t sinks = 0;
  // The sink of the largest ortho-radius, of several the first by the places of its centres: what
  // the cavity is known by while alpha moves.
  std::uint32_t deepest_sink = 0;
  // A part of a network (split_networks.hpp): which of Cavities::networks it is of, and the
  // triangles not in K_alpha between it and other parts, joined as those of mouths are. Of kWhole:
  // none.
  std::uint32_t network = kWhole;
  std::vector<Mouth> passages;

  // From so many mouths on a pocket is a network of gaps that are connected rather than one hole.
  // Above what symmetry gives a hollow shell: a cage of 24 equal parts opens at its eight threefold
  // and six fourfold axes, which are 14.
  static constexpr std::size_t kMouthsOfNetwork = 20;

  // A part without mouths is open to other parts.
  bool is_void() const { return mouths.empty() && passages.empty(); }
  bool is_part() const { return network != kWhole; }
  bool is_network() const { return !is_part() && mouths.size() >= kMouthsOfNetwork; }
  std::size_t mouth_triangles() const;
  friend bool operator==(const Cavity&, const Cavity&) = default;
};

// A network that is listed as its parts.
struct SplitNetwork {
  std::uint32_t deepest_sink = 0;  // that of one of the parts, too
  std::size_t mouths = 0, tetrahedra = 0, parts = 0;
  Alpha falls_apart_angstrom2;  // NetworkParting's
  friend bool operator==(const SplitNetwork&, const SplitNetwork&) = default;
};

struct Cavities {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<Cavity> cavities;  // by their first tetrahedra
  // Of each tetrahedron the index of its cavity, or kNone.
  ResultArray<std::uint32_t> cavity_of_tetrahedron;
  std::array<std::size_t, 4> simplices{};  // of K_alpha, by dimension
  // Connected components, tunnels and voids of K_alpha. Where there are several components, spaces
  // between bodies count as pockets.
  long long components = 0, tunnels = 0, voids = 0;
  std::vector<SplitNetwork> networks;  // split_networks() makes them

  friend bool operator==(const Cavities&, const Cavities&) = default;
};

// Of the K_alpha that `membership` says. Works in the caller's task arena; the same for any number
// of threads. Throws Cancelled, and InternalError for what contradicts the definitions.
Cavities find_cavities(const CavityGround& ground, const Membership& membership,
                       OutsideRule rule = OutsideRule::castp, const CancelToken& cancel = {});

}  // namespace alphascope
