// SPDX-License-Identifier: GPL-3.0-or-later
// The connected components of K_alpha that a cavity touches.
#pragma once

#include <algorithm>
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
  std::vector<std::uint32_t> roots;  // hardly ever more than two
  for (const BallIndex v : cavity.atoms) {
    const std::uint32_t root = sets.root(v);
    if (std::find(roots.begin(), roots.end(), root) == roots.end()) roots.push_back(root);
  }
  return static_cast<std::uint32_t>(roots.size());
}

}  // namespace alphascope
