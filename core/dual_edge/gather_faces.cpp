// SPDX-License-Identifier: GPL-3.0-or-later
// Edges and vertices of the complex, completed from their cofaces in parallel.
#include "core/dual_edge/gather_faces.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "core/run/internal_error.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

void lower(float& shared, float value) {
  std::atomic_ref<float> least(shared);
  float old = least.load(std::memory_order_relaxed);
  while (value < old && !least.compare_exchange_weak(old, value, std::memory_order_relaxed)) {
  }
}

void add_flags(std::uint8_t& shared, std::uint32_t flags) {
  std::atomic_ref<std::uint8_t> all(shared);
  if ((all.load(std::memory_order_relaxed) & flags) != flags)
    all.fetch_or(static_cast<std::uint8_t>(flags), std::memory_order_relaxed);
}

// The index of edge jk of triangle ijk among the edges of ball j. It must exist: a triangle is
// kept, and an edge dropped, only with certainty.
std::size_t find_edge(const EdgeRange& of_j, const std::array<BallIndex, 3>& triangle) {
  const std::array edge{triangle[1], triangle[2]};
  if (of_j.edges != nullptr) {
    const auto all = of_j.edges->simplices.begin();
    const auto end = all + of_j.end, at = std::lower_bound(all + of_j.begin, end, edge);
    if (at != end && *at == edge) return static_cast<std::size_t>(at - all);
  }
  throw InternalError("triangle " + std::to_string(triangle[0]) + " " +
                      std::to_string(triangle[1]) + " " + std::to_string(triangle[2]) +
                      " is in the complex without its edge " + std::to_string(edge[0]) + " " +
                      std::to_string(edge[1]) + ".");
}

}  // namespace

void gather_edges(const std::vector<EdgeRange>& ranges, AlphaComplex& complex) {
  parallel_each(0, complex.triangles.size(), [&](std::size_t t) {
    const std::array<BallIndex, 3>& triangle = complex.triangles.simplices[t];
    const EdgeRange& r = ranges[triangle[1]];
    const std::size_t e = find_edge(r, triangle);
    lower(r.edges->values[e], complex.triangles.alpha_values[t]);
    add_flags(r.edges->states[e], coface_flags(complex.triangles.classes[t]));
  });

  std::vector<std::size_t> place(ranges.size() + 1, 0);
  parallel_each(0, ranges.size(), [&](std::size_t i) {
    for (std::uint32_t e = ranges[i].begin; e < ranges[i].end; ++e)
      place[i + 1] += is_in_complex(ranges[i].edges->states[e]);
  });
  for (std::size_t i = 0; i < ranges.size(); ++i) place[i + 1] += place[i];
  SimplexList<2>& list = complex.edges;
  list.simplices.resize(place.back());
  list.alpha_values.resize(place.back());
  list.classes.resize(place.back());
  parallel_each(0, ranges.size(), [&](std::size_t i) {
    std::size_t to = place[i];
    for (std::uint32_t e = ranges[i].begin; e < ranges[i].end; ++e) {
      const SimplexBuffer<2>& from = *ranges[i].edges;
      if (!is_in_complex(from.states[e])) continue;
      list.simplices[to] = from.simplices[e];
      list.alpha_values[to] = from.values[e];
      list.classes[to++] = face_class(from.states[e]);
    }
  });
}

void gather_vertices(const BallSet& balls, const std::vector<VertexState>& states,
                     AlphaComplex& complex) {
  std::vector<std::uint8_t> flags(balls.size(), 0);
  std::vector<float> nearest(balls.size(), HUGE_VALF);
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    const std::uint32_t own = coface_flags(complex.edges.classes[e]);
    for (const BallIndex v : complex.edges.simplices[e]) {
      flags[v] = static_cast<std::uint8_t>(flags[v] | own);
      nearest[v] = std::min(nearest[v], complex.edges.alpha_values[e]);
    }
  }
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const std::uint32_t all = flags[i] | (states[i] == VertexState::unattached ? kUnattached : 0);
    if (!is_in_complex(all)) continue;
    const auto own = [&] { return static_cast<float>(-static_cast<double>(balls.weight(i))); };
    complex.vertices.simplices.push_back({i});
    complex.vertices.alpha_values.push_back(face_value(all, nearest[i], own));
    complex.vertices.classes.push_back(face_class(all));
  }
}

}  // namespace alphascope
