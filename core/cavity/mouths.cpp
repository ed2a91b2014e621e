// SPDX-License-Identifier: GPL-3.0-or-later
// Groups the triangles of a cavity's openings into mouths, by shared edges and vertices that are
// not in K_alpha.
#include "core/cavity/mouths.hpp"

#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/wide_int.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

// For each edge or vertex the last cavity and triangle that visited it.
// Pairs of cavity and triangle.
using LastVisitor = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

class MouthGroups {
 public:
  MouthGroups(const CavityGround& ground, const Membership& membership)
      : ground_(ground),
        in_(membership),
        at_edge_(membership.edges.size(), {Cavities::kNone, 0}),
        at_vertex_(membership.vertices.size(), {Cavities::kNone, 0}) {}

  std::vector<Mouth> of(std::uint32_t cavity, const std::vector<std::uint32_t>& triangles) {
    UnionFind groups(triangles.size());
    for (std::uint32_t n = 0; n < triangles.size(); ++n) {
      for (const std::uint32_t e : ground_.incidence.edges_of_triangle[triangles[n]]) {
        if (!in_.edges[e]) join(cavity, n, at_edge_[e], groups);
      }
      for (const BallIndex v : ground_.incidence.triangles[triangles[n]]) {
        if (!in_.vertices[v]) join(cavity, n, at_vertex_[v], groups);
      }
    }
    std::vector<Mouth> mouths;
    std::vector<std::uint32_t> mouth_of(triangles.size());
    for (std::uint32_t n = 0; n < triangles.size(); ++n) {
      const std::uint32_t first = groups.root(n);  // at most n
      if (first == n) {
        mouth_of[n] = static_cast<std::uint32_t>(mouths.size());
        mouths.emplace_back();
      }
      mouths[mouth_of[first]].triangles.push_back(triangles[n]);
    }
    return mouths;
  }

 private:
  static void join(std::uint32_t cavity, std::uint32_t triangle,
                   std::pair<std::uint32_t, std::uint32_t>& last, UnionFind& groups) {
    if (last.first == cavity) groups.unite(last.second, triangle);
    last = {cavity, triangle};
  }

  const CavityGround& ground_;
  const Membership& in_;
  LastVisitor at_edge_, at_vertex_;
};

}  // namespace

void set_mouths(const CavityGround& ground, const Membership& membership,
                const std::vector<std::vector<std::uint32_t>>& opening,
                std::vector<Cavity>& cavities) {
  MouthGroups groups(ground, membership);
  for (std::uint32_t c = 0; c < cavities.size(); ++c) {
    if (!opening[c].empty()) cavities[c].mouths = groups.of(c, opening[c]);
  }
}

}  // namespace alphascope
