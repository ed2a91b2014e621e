// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the mouths of all descendants of a network while alpha falls. As alpha falls, tetrahedra
// join into larger cavities, and triangles into larger mouths; neither ever splits.
#include "core/cavity/mouth_counts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_class.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = Cavities::kNone;

// An event while alpha falls: below `value` this simplex is no longer in K_alpha.
struct Opening {
  enum class What : std::uint8_t { passage, mouth, corner };
  float value;
  What what;
  // passage: a triangle inside the network; mouth, corner: an index in triangles_ or corners_
  std::uint32_t index;
};

std::vector<std::uint32_t> triangles_of_mouths(const Cavity& cavity) {
  std::vector<std::uint32_t> triangles;
  for (const Mouth& mouth : cavity.mouths) {
    triangles.insert(triangles.end(), mouth.triangles.begin(), mouth.triangles.end());
  }
  return triangles;
}

class MouthCounts {
 public:
  MouthCounts(const CavityGround& ground, const Filtration& filtration,
              const Membership& membership, const Cavities& found, std::uint32_t index)
      : ground_(ground),
        values_(filtration.top()),
        in_(membership),
        found_(found),
        index_(index),
        cavity_(found.cavities[index]),
        triangles_(triangles_of_mouths(cavity_)) {
    list_corners();
    add_passages();
    for (std::uint32_t n = 0; n < triangles_.size(); ++n) {
      openings_.push_back({values_.triangles.alpha_values[triangles_[n]], Opening::What::mouth, n});
    }
    std::sort(openings_.begin(), openings_.end(),
              [](const Opening& a, const Opening& b) { return a.value > b.value; });
  }

  std::vector<RangeWithoutNetwork> quiet(const CancelToken& cancel) {
    begin();
    std::vector<RangeWithoutNetwork> ranges;
    float above = std::numeric_limits<float>::infinity();
    for (std::size_t n = 0; n <= openings_.size(); ++n) {
      const bool last = n == openings_.size();
      const float value = last ? -std::numeric_limits<float>::infinity() : openings_[n].value;
      if (value < above || last) {
        cancel.throw_if_cancelled();
        if (networks_ == 0) add_range(ranges, value, above);
        above = value;
      }
      if (!last) open(openings_[n]);
    }
    std::reverse(ranges.begin(), ranges.end());
    return ranges;
  }

 private:
  static void add_range(std::vector<RangeWithoutNetwork>& falling, float from, float to) {
    if (!falling.empty() && falling.back().from == to) {
      falling.back().from = from;
    } else {
      falling.push_back({from, to});
    }
  }

  // An edge or vertex of triangles of mouths. While it is not in K_alpha, it joins the open
  // triangles around it into one mouth, if they are of one cavity.
  struct Corner {
    float value = 0;
    bool open = false;
    std::vector<std::uint32_t> around;  // indices of triangles_
  };
  void list_corners() {
    corners_of_.resize(triangles_.size());
    std::vector<std::uint32_t> vertex(in_.vertices.size(), kNone), edge(in_.edges.size(), kNone);
    const auto add = [&](std::uint32_t& corner, float value, std::uint32_t n) {
      if (corner == kNone) {
        corner = static_cast<std::uint32_t>(corners_.size());
        corners_.push_back({value, false, {}});
      }
      corners_[corner].around.push_back(n);
      corners_of_[n].push_back(corner);
    };
    std::vector<float> value_of_ball(in_.vertices.size(), 0);
    for (std::size_t v = 0; v < values_.vertices.size(); ++v) {
      value_of_ball[values_.vertices.simplices[v][0]] = values_.vertices.alpha_values[v];
    }
    for (std::uint32_t n = 0; n < triangles_.size(); ++n) {
      for (const std::uint32_t e : ground_.incidence.edges_of_triangle[triangles_[n]]) {
        if (!in_.edges[e]) add(edge[e], values_.edges.alpha_values[e], n);
      }
      for (const BallIndex v : ground_.incidence.triangles[triangles_[n]]) {
        if (!in_.vertices[v]) add(vertex[v], value_of_ball[v], n);
      }
    }
    for (std::uint32_t k = 0; k < corners_.size(); ++k) {
      openings_.push_back({corners_[k].value, Opening::What::corner, k});
    }
  }

  void add_passages() {
    for (const std::uint32_t t : cavity_.tetrahedra) {
      for (const std::uint32_t f : ground_.incidence.triangles_of_tetrahedron[t]) {
        const auto [a, b] = ground_.incidence.tetrahedra_of_triangle[f];
        const bool inner = a == t && b != Incidence::kOutside && !in_.triangles[f] &&
                           found_.cavity_of_tetrahedron[b] == index_;
        if (inner) {
          openings_.push_back({values_.triangles.alpha_values[f], Opening::What::passage, f});
        }
      }
    }
  }

  void begin() {
    mouths_of_.resize(cavity_.tetrahedra.size());
    count_.assign(cavity_.tetrahedra.size(), 0);
    is_open_.assign(triangles_.size(), false);
  }

  std::uint32_t local(std::uint32_t tetrahedron) const {
    const auto& all = cavity_.tetrahedra;
    return static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), tetrahedron) -
                                      all.begin());
  }
  std::uint32_t cavity_at(std::uint32_t n) {
    const auto [a, b] = ground_.incidence.tetrahedra_of_triangle[triangles_[n]];
    const bool of_a = found_.cavity_of_tetrahedron[a] == index_;
    return sets_.root(local(of_a ? a : b));
  }

  void open(const Opening& opening) {
    switch (opening.what) {
      case Opening::What::passage: {
        const auto [a, b] = ground_.incidence.tetrahedra_of_triangle[opening.index];
        return join_cavities(sets_.root(local(a)), sets_.root(local(b)));
      }
      case Opening::What::mouth: {
        const std::uint32_t cavity = cavity_at(opening.index);
        is_open_[opening.index] = true;
        mouths_of_[cavity].push_back(opening.index);
        change(cavity, 1);
        return join_around(opening.index, cavity);
      }
      default: {
        Corner& corner = corners_[opening.index];
        corner.open = true;
        for (const std::uint32_t n : corner.around) {
          if (is_open_[n]) join_at(corner, n, cavity_at(n));
        }
      }
    }
  }

  void join_cavities(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    networks_ -= is_network(a) + is_network(b);
    sets_.unite(a, b);
    const std::uint32_t kept = std::min(a, b), gone = std::max(a, b);
    count_[kept] += std::exchange(count_[gone], 0);
    networks_ += is_network(kept);
    auto &all = mouths_of_[kept], &more = mouths_of_[gone];
    if (all.size() < more.size()) std::swap(all, more);
    const std::vector<std::uint32_t> smaller = std::exchange(more, {});
    all.insert(all.end(), smaller.begin(), smaller.end());
    for (const std::uint32_t n : smaller) join_around(n, kept);
  }

  void join_around(std::uint32_t n, std::uint32_t cavity) {
    for (const std::uint32_t corner : corners_of_[n]) {
      if (corners_[corner].open) join_at(corners_[corner], n, cavity);
    }
  }
  void join_at(const Corner& corner, std::uint32_t n, std::uint32_t cavity) {
    for (const std::uint32_t other : corner.around) {
      if (!is_open_[other] || groups_.root(other) == groups_.root(n)) continue;
      if (cavity_at(other) != cavity) continue;
      groups_.unite(other, n);
      change(cavity, -1);
    }
  }

  bool is_network(std::uint32_t cavity) const {
    return count_[cavity] >= static_cast<long>(Cavity::kMouthsOfNetwork);
  }
  void change(std::uint32_t cavity, int by) {
    networks_ -= is_network(cavity);
    count_[cavity] += by;
    networks_ += is_network(cavity);
  }

  const CavityGround& ground_;
  const AlphaComplex& values_;
  const Membership& in_;
  const Cavities& found_;
  const std::uint32_t index_;
  const Cavity& cavity_;
  const std::vector<std::uint32_t> triangles_;  // all triangles of the network's mouths
  std::vector<Corner> corners_;
  std::vector<std::vector<std::uint32_t>> corners_of_;  // for each of triangles_
  std::vector<Opening> openings_;

  UnionFind sets_{cavity_.tetrahedra.size()}, groups_{triangles_.size()};
  // For each root of sets_ the indices of triangles_ that are open.
  std::vector<std::vector<std::uint32_t>> mouths_of_;
  std::vector<long> count_;    // for each root of sets_ its number of mouths
  std::vector<bool> is_open_;  // for each of triangles_
  long networks_ = 0;
};

}  // namespace

std::vector<RangeWithoutNetwork> ranges_without_network(const CavityGround& ground,
                                                        const Filtration& filtration,
                                                        const Membership& membership,
                                                        const Cavities& found, std::uint32_t index,
                                                        const CancelToken& cancel) {
  return MouthCounts(ground, filtration, membership, found, index).quiet(cancel);
}

}  // namespace alphascope
