// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts the simplices that are valid by themselves, and merges them with the faces of their
// cofaces, from tetrahedra down to vertices.
#include "core/tuples/tuple_closure.hpp"

#include <algorithm>
#include <cmath>

#include "core/complex/face_groups.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

template <int N>
struct Valued {
  std::array<BallIndex, N> simplex;
  float value;
};

// Sorts in lexicographic order: a counting sort by first vertex, then a sort for each first vertex.
template <int N>
void sort_own(UnattachedSimplices<N>& own, std::size_t ball_count) {
  if (own.values.empty()) {
    sort_simplices<N>(own.simplices, ball_count);
    return;
  }
  require_face_records(own.simplices.size(), 1);
  std::vector<std::uint32_t> bucket(ball_count + 1, 0);
  for (const auto& s : own.simplices) ++bucket[s[0] + 1];
  for (std::size_t b = 1; b < bucket.size(); ++b) bucket[b] += bucket[b - 1];
  std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
  std::vector<Valued<N>> sorted(own.simplices.size());
  for (std::size_t n = 0; n < sorted.size(); ++n) {
    sorted[next[own.simplices[n][0]]++] = {own.simplices[n], own.values[n]};
  }
  parallel_each(0, ball_count, [&](std::size_t v) {
    const auto begin = sorted.begin() + bucket[v], end = sorted.begin() + bucket[v + 1];
    std::sort(begin, end, [](const auto& a, const auto& b) { return a.simplex < b.simplex; });
    for (auto at = begin; at != end; ++at) {
      const auto n = static_cast<std::size_t>(at - sorted.begin());
      own.simplices[n] = at->simplex;
      own.values[n] = at->value;
    }
  });
}

// Merges the faces of the cofaces with the simplices that are valid by themselves, both in order.
template <int N>
void close(UnattachedSimplices<N> own, const SimplexList<N + 1>& cofaces, std::size_t ball_count,
           SimplexList<N>& list) {
  sort_own<N>(own, ball_count);
  const FaceGroups<N> groups(cofaces.simplices);
  list.simplices.reserve(std::max(groups.size(), own.simplices.size()));
  std::size_t g = 0, o = 0;
  while (g < groups.size() || o < own.simplices.size()) {
    const bool is_own =
        o < own.simplices.size() && (g == groups.size() || own.simplices[o] <= groups.faces()[g]);
    const bool is_face =
        g < groups.size() && (o == own.simplices.size() || groups.faces()[g] <= own.simplices[o]);
    float least = HUGE_VALF;
    std::uint32_t flags = is_own ? kUnattached : 0;
    if (is_face) {
      if (N == 3) flags |= triangle_flags(groups.coface_count(g));
      groups.for_cofaces(g, [&](std::uint32_t c) {
        least = std::min(least, cofaces.alpha_values[c]);
        flags |= coface_flags(cofaces.classes[c]);
      });
    }
    list.simplices.push_back(is_own ? own.simplices[o] : groups.faces()[g]);
    list.alpha_values.push_back(face_value(flags, least, [&] { return own.values[o]; }));
    list.classes.push_back(face_class(flags));
    o += is_own;
    g += is_face;
  }
}

}  // namespace

void complete_complex(UnattachedSimplicesByDimension own, std::size_t ball_count,
                      AlphaComplex& complex) {
  sort_own<4>(own.tetrahedra, ball_count);
  SimplexList<4>& tetrahedra = complex.tetrahedra;
  tetrahedra.simplices = std::move(own.tetrahedra.simplices);
  if (complex.tetrahedra_only) return;
  tetrahedra.alpha_values = std::move(own.tetrahedra.values);
  tetrahedra.classes.assign(tetrahedra.size(), SimplexClass::interior);
  close<3>(std::move(own.triangles), tetrahedra, ball_count, complex.triangles);
  close<2>(std::move(own.edges), complex.triangles, ball_count, complex.edges);
  close<1>(std::move(own.vertices), complex.edges, ball_count, complex.vertices);
}

}  // namespace alphascope
