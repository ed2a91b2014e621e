// SPDX-License-Identifier: GPL-3.0-or-later
// Groups the triangles of a cavity's openings into mouths, by shared edges and vertices that are
// not in K_alpha.
#include "core/cavity/mouths.hpp"

#include <tbb/parallel_sort.h>

#include <mutex>
#include <span>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

// A face of a triangle, and the number of the triangle in a list.
struct FaceOf {
  std::uint32_t face, triangle;
  bool operator<(const FaceOf& other) const { return face < other.face; }
};

// Unites triangles with the same face.
void unite(std::vector<FaceOf>& faces, UnionFind& groups) {
  tbb::parallel_sort(faces.begin(), faces.end());
  for (std::size_t n = 1; n < faces.size(); ++n) {
    if (faces[n].face == faces[n - 1].face) groups.unite(faces[n].triangle, faces[n - 1].triangle);
  }
}

std::vector<Mouth> mouths_of(const CavityGround& ground, const Membership& in,
                             std::span<const std::uint32_t> triangles) {
  UnionFind groups(triangles.size());
  std::vector<FaceOf> edges, vertices;
  std::mutex mutex;
  constexpr std::size_t kGrain = 1024;
  parallel_ranges(0, triangles.size(), kGrain, [&](std::size_t first, std::size_t end) {
    std::vector<FaceOf> own_edges, own_vertices;
    for (auto n = static_cast<std::uint32_t>(first); n < end; ++n) {
      for (const std::uint32_t e : ground.incidence.edges_of_triangle[triangles[n]]) {
        if (!in.edges[e]) own_edges.push_back({e, n});
      }
      for (const BallIndex v : ground.incidence.triangles[triangles[n]]) {
        if (!in.vertices[v]) own_vertices.push_back({v, n});
      }
    }
    const std::lock_guard lock(mutex);
    edges.insert(edges.end(), own_edges.begin(), own_edges.end());
    vertices.insert(vertices.end(), own_vertices.begin(), own_vertices.end());
  });
  unite(edges, groups);
  unite(vertices, groups);
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

}  // namespace

void set_mouths(const CavityGround& ground, const Membership& membership, const Grouped& opening,
                std::vector<Cavity>& cavities) {
  parallel_each(0, cavities.size(), [&](std::size_t c) {
    if (!opening.of(c).empty()) cavities[c].mouths = mouths_of(ground, membership, opening.of(c));
  });
}

}  // namespace alphascope
