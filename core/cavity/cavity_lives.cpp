// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the intervals of alpha in which cavities exist, by joining tetrahedra while alpha falls.
#include "core/cavity/cavity_lives.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/cavity/gates.hpp"
#include "core/cavity/inside.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

// All triangles as gates, in the order in which a falling alpha opens them: that with the largest
// value of `closes` first.
std::vector<Gate> gates(const CavityGround& ground, const CancelToken& cancel) {
  std::vector<Gate> all(ground.incidence.triangles.size());
  parallel_many(all.size(), cancel,
                [&](std::size_t f) { all[f] = gate_of(ground, static_cast<std::uint32_t>(f)); });
  tbb::parallel_sort(all.begin(), all.end(), [](const Gate& a, const Gate& b) {
    return a.closes != b.closes ? a.closes > b.closes : a.triangle < b.triangle;
  });
  cancel.throw_if_cancelled();
  return all;
}

// Sets of tetrahedra that grow while alpha falls, each with its deepest sink. One more item stands
// for infinity, which counts as deeper than all sinks.
class Basins {
 public:
  explicit Basins(const CavityGround& ground)
      : ground_(ground),
        infinity_(static_cast<std::uint32_t>(ground.flow.marks.size())),
        sets_(infinity_ + 1),
        deepest_(infinity_ + 1, Cavities::kNone) {
    for (std::uint32_t t = 0; t < infinity_; ++t) {
      if (ground.flow.is_sink(t)) deepest_[t] = t;
    }
    deepest_[infinity_] = infinity_;
  }
  std::uint32_t infinity() const { return infinity_; }

  // Joins the sets of a and b. Returns the sink that is no longer the deepest of its set, or kNone.
  std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    a = sets_.root(a);
    b = sets_.root(b);
    if (a == b) return Cavities::kNone;
    auto [kept, lost] = std::pair(deepest_[a], deepest_[b]);
    if (is_deeper(lost, kept)) std::swap(kept, lost);
    sets_.unite(a, b);
    deepest_[std::min(a, b)] = kept;
    return lost;
  }

 private:
  bool is_deeper(std::uint32_t a, std::uint32_t b) const {
    if (a == Cavities::kNone || b == infinity_) return false;
    if (b == Cavities::kNone || a == infinity_) return true;
    return is_deeper_sink(ground_, a, b);
  }

  const CavityGround& ground_;
  const std::uint32_t infinity_;
  UnionFind sets_;
  std::vector<std::uint32_t> deepest_;  // for each root
};

void set_places(const CavityGround& ground, CavityLives& lives) {
  std::vector<std::uint32_t> order(lives.sinks.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto& tetrahedra = ground.triangulation->tetrahedra;
  tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return comes_first(*ground.balls, tetrahedra[lives.sinks[a]], tetrahedra[lives.sinks[b]]);
  });
  lives.places.resize(order.size());
  for (std::uint32_t place = 0; place < order.size(); ++place) lives.places[order[place]] = place;
}

}  // namespace

const CavityLife& CavityLives::of(std::uint32_t sink) const {
  const auto at = std::lower_bound(sinks.begin(), sinks.end(), sink);
  if (at == sinks.end() || *at != sink) throw std::invalid_argument("no such sink");
  return lives[static_cast<std::size_t>(at - sinks.begin())];
}

CavityLives cavity_lives(const CavityGround& ground, OutsideRule rule, const CancelToken& cancel) {
  if (ground.triangulation->dimension < 3) return {};
  constexpr float kEver = -std::numeric_limits<float>::infinity();
  std::vector<CavityLife> of(ground.flow.marks.size(), {kEver, kEver, 0});
  // `inside` joins only tetrahedra of cavities, and so finds births. `space` also joins outside
  // tetrahedra and infinity, and so finds when the last mouth closes.
  Basins inside(ground), space(ground);
  for (const Gate& gate : gates(ground, cancel)) {
    const auto [a, beyond] = ground.incidence.tetrahedra_of_triangle[gate.triangle];
    const bool hull = beyond == Incidence::kOutside;
    const std::uint32_t closed = space.join(a, hull ? space.infinity() : beyond);
    if (closed != Cavities::kNone) of[closed].closed = gate.closes;
    if (hull || !is_inside_if_empty(ground.flow, a, rule) ||
        !is_inside_if_empty(ground.flow, beyond, rule)) {
      continue;
    }
    const std::uint32_t born = inside.join(a, beyond);
    if (born != Cavities::kNone) of[born].born = gate.closes;
  }
  CavityLives lives;
  for (std::uint32_t t = 0; t < of.size(); ++t) {
    if (!ground.flow.is_sink(t)) continue;
    of[t].gone = ground.flow.alpha_values[t];
    lives.sinks.push_back(t);
    lives.lives.push_back(of[t]);
  }
  set_places(ground, lives);
  return lives;
}

}  // namespace alphascope
