// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts tetrahedra in lexicographic order, renumbers their neighbours and makes the facets of the
// hull.
#include "core/insertion/order_tetrahedra.hpp"

#include <utility>

#include "core/complex/count_limits.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

std::array<BallIndex, 3> face_opposite(const std::array<BallIndex, 4>& tetrahedron, int corner) {
  std::array<BallIndex, 3> face;
  for (int k = 0, n = 0; k < 4; ++k) {
    if (k != corner) face[n++] = tetrahedron[k];
  }
  return face;
}

// The face, oriented so that the tetrahedron is behind it.
HullFacet hull_facet(const BallSet& balls, const OutsideFace& outside) {
  HullFacet facet{face_opposite(outside.balls, outside.corner), outside.tetrahedron};
  const auto seen_from_first = [&](BallIndex k) { return lifted_vector(balls, facet.balls[0], k); };
  if (determinant(seen_from_first(facet.balls[1]), seen_from_first(facet.balls[2]),
                  seen_from_first(outside.balls[outside.corner])) > 0) {
    std::swap(facet.balls[1], facet.balls[2]);
  }
  return facet;
}

}  // namespace

std::vector<HullFacet> hull_facets(const BallSet& balls, std::vector<OutsideFace>& outside) {
  std::sort(outside.begin(), outside.end(), [](const OutsideFace& a, const OutsideFace& b) {
    return face_opposite(a.balls, a.corner) < face_opposite(b.balls, b.corner);
  });
  std::vector<HullFacet> facets;
  facets.reserve(outside.size());
  for (const OutsideFace& face : outside) facets.push_back(hull_facet(balls, face));
  return facets;
}

void set_hull(std::vector<HullFacet> facets, const std::vector<OutsideFace>& outside,
              Triangulation& result) {
  for (std::uint32_t index = 0; index < outside.size(); ++index) {
    const auto& [t, corner, balls] = outside[index];
    result.neighbours[t][corner] = Neighbour::hull_facet(index);
  }
  result.hull = std::move(facets);
}

void set_vertices(std::size_t balls, const CancelToken& cancel, Triangulation& result) {
  std::vector<char> visible(balls, 0);
  for_ranges(result.tetrahedra.size(), cancel, [&](std::size_t first, std::size_t end) {
    for (std::size_t t = first; t != end; ++t) {
      for (const BallIndex i : result.tetrahedra[t])
        std::atomic_ref(visible[i]).store(1, std::memory_order_relaxed);
    }
  });
  for (std::size_t i = 0; i < balls; ++i)
    (visible[i] ? result.vertices : result.hidden).push_back(static_cast<BallIndex>(i));
}

void TetrahedronOrder::begin_placing() {
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  require_at_most(size(), Neighbour::kMostIndex, "tetrahedra");
  next_.assign(first_.begin(), first_.end() - 1);
  records_.resize(size());
}

void TetrahedronOrder::sort(const CancelToken& cancel, Simplices<4>& tetrahedra) {
  constexpr std::size_t kGrain = 1024;
  tetrahedra.resize(size());
  parallel_ranges(0, next_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    for (std::size_t i = begin; i != end; ++i)
      std::sort(records_.begin() + first_[i], records_.begin() + first_[i + 1]);
    for (std::uint32_t t = first_[begin]; t != first_[end]; ++t) {
      tetrahedra[t] = records_[t].balls;
      after_[records_[t].slot] = t;
    }
  });
  cancel.throw_if_cancelled();
}

}  // namespace alphascope
