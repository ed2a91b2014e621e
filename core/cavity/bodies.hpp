// SPDX-License-Identifier: GPL-3.0-or-later
// The connected components of K_alpha that a cavity touches.
#pragma once

#include <algorithm>
#include <mutex>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {

// The components of K_alpha as sets of balls: joined by the edges in K_alpha.
inline UnionFind joined_balls(const CavityGround& ground, const Membership& in,
                              const CancelToken& cancel) {
  UnionFind sets(in.vertices.size());
  parallel_many(in.edges.size(), cancel, [&](std::size_t e) {
    if (in.edges[e]) sets.unite(ground.incidence.edges[e][0], ground.incidence.edges[e][1]);
  });
  return sets;
}

// The number of these sets to which the atoms of a cavity belong.
inline std::uint32_t count_bodies(const Cavity& cavity, UnionFind& sets) {
  constexpr std::size_t kGrain = 4096;
  const auto add = [](std::uint32_t root, std::vector<std::uint32_t>& to) {
    if (std::find(to.begin(), to.end(), root) == to.end()) to.push_back(root);
  };
  std::vector<std::uint32_t> roots;  // hardly ever more than two
  std::mutex mutex;
  parallel_ranges(0, cavity.atoms.size(), kGrain, [&](std::size_t first, std::size_t end) {
    std::vector<std::uint32_t> own;
    for (std::size_t n = first; n != end; ++n) add(sets.root(cavity.atoms[n]), own);
    const std::lock_guard lock(mutex);
    for (const std::uint32_t root : own) add(root, roots);
  });
  return static_cast<std::uint32_t>(roots.size());
}

}  // namespace alphascope
