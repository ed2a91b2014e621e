#include "core/complex/gather_faces.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace alphascope {
namespace {

std::uint8_t flags_of(SimplexClass coface) {
  return coface == SimplexClass::interior ? kHasCoface : kHasCoface | kHasBoundaryCoface;
}

SimplexClass class_of(std::uint8_t flags) {
  return !(flags & kHasCoface)          ? SimplexClass::singular
         : (flags & kHasBoundaryCoface) ? SimplexClass::regular
                                        : SimplexClass::interior;
}

void lower(float& shared, float value) {
  std::atomic_ref<float> least(shared);
  float old = least.load(std::memory_order_relaxed);
  while (value < old && !least.compare_exchange_weak(old, value, std::memory_order_relaxed)) {
  }
}

void add_flags(std::uint8_t& shared, std::uint8_t flags) {
  std::atomic_ref<std::uint8_t> all(shared);
  if ((all.load(std::memory_order_relaxed) & flags) != flags)
    all.fetch_or(flags, std::memory_order_relaxed);
}

// Unattached, or attached to a triangle of K_alpha.
bool is_present(const SimplexBuffer<2>& edges, std::uint32_t e) {
  return edges.values[e] < HUGE_VALF;
}

}  // namespace

void gather_edges(const std::vector<EdgeRange>& ranges, AlphaComplex& complex) {
  tbb::parallel_for(std::size_t{0}, complex.triangles.size(), [&](std::size_t t) {
    const auto [i, j, k] = complex.triangles.simplices[t];
    const EdgeRange& r = ranges[j];
    const auto first = r.edges->simplices.begin();
    const auto at = std::lower_bound(first + r.begin, first + r.end, std::array{j, k}) - first;
    const auto e = static_cast<std::size_t>(at);
    lower(r.edges->values[e], complex.triangles.alpha_values[t]);
    add_flags(r.edges->states[e], flags_of(complex.triangles.classes[t]));
  });

  std::vector<std::size_t> place(ranges.size() + 1, 0);
  tbb::parallel_for(std::size_t{0}, ranges.size(), [&](std::size_t i) {
    for (std::uint32_t e = ranges[i].begin; e < ranges[i].end; ++e)
      place[i + 1] += is_present(*ranges[i].edges, e);
  });
  for (std::size_t i = 0; i < ranges.size(); ++i) place[i + 1] += place[i];
  SimplexList<2>& list = complex.edges;
  list.simplices.resize(place.back());
  list.alpha_values.resize(place.back());
  list.classes.resize(place.back());
  tbb::parallel_for(std::size_t{0}, ranges.size(), [&](std::size_t i) {
    std::size_t to = place[i];
    for (std::uint32_t e = ranges[i].begin; e < ranges[i].end; ++e) {
      const SimplexBuffer<2>& from = *ranges[i].edges;
      if (!is_present(from, e)) continue;
      list.simplices[to] = from.simplices[e];
      list.alpha_values[to] = from.values[e];
      list.classes[to++] = class_of(from.states[e]);
    }
  });
}

void gather_vertices(const BallSet& balls, const std::vector<VertexState>& states,
                     AlphaComplex& complex) {
  std::vector<std::uint8_t> flags(balls.size(), 0);
  std::vector<float> nearest(balls.size(), HUGE_VALF);
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    const std::uint8_t own = flags_of(complex.edges.classes[e]);
    for (const BallIndex v : complex.edges.simplices[e]) {
      flags[v] = static_cast<std::uint8_t>(flags[v] | own);
      nearest[v] = std::min(nearest[v], complex.edges.alpha_values[e]);
    }
  }
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const bool attached = states[i] == VertexState::attached;
    if (states[i] == VertexState::absent || (attached && !(flags[i] & kHasCoface))) continue;
    complex.vertices.simplices.push_back({i});
    complex.vertices.alpha_values.push_back(
        attached ? nearest[i] : static_cast<float>(-static_cast<double>(balls.weight(i))));
    complex.vertices.classes.push_back(class_of(flags[i]));
  }
}

}  // namespace alphascope
