// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts tetrahedra in lexicographic order, renumbers their neighbours and makes the facets of the
// hull.
#include "core/triangulation/order_tetrahedra.hpp"

#include <utility>

#include "core/complex/count_limits.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

struct Record {
  std::array<BallIndex, 4> balls;
  std::uint32_t before;  // index in the given order
  bool operator<(const Record& other) const { return balls < other.balls; }
};

// Sorts the tetrahedra into buckets by their lowest ball, some seven to a bucket, and then sorts
// each bucket.
ResultArray<Record> sorted_records(const Simplices<4>& tetrahedra, std::size_t balls,
                                   const CancelToken& cancel) {
  std::vector<std::uint32_t> first(balls + 1, 0);
  for (const auto& t : tetrahedra) ++first[t[0] + 1];
  for (std::size_t i = 0; i < balls; ++i) first[i + 1] += first[i];
  cancel.throw_if_cancelled();
  ResultArray<Record> records(tetrahedra.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    records[next[tetrahedra[t][0]]++] = {tetrahedra[t], t};
  }
  parallel_each(0, balls, [&](std::size_t i) {
    if (!cancel.cancelled()) std::sort(records.begin() + first[i], records.begin() + first[i + 1]);
  });
  cancel.throw_if_cancelled();
  return records;
}

std::array<BallIndex, 3> face_opposite(const std::array<BallIndex, 4>& tetrahedron, int corner) {
  std::array<BallIndex, 3> face;
  for (int k = 0, n = 0; k < 4; ++k) {
    if (k != corner) face[n++] = tetrahedron[k];
  }
  return face;
}

// The face opposite a corner, oriented so that the tetrahedron is behind it.
HullFacet hull_facet(const BallSet& balls, std::uint32_t t,
                     const std::array<BallIndex, 4>& tetrahedron, int corner) {
  HullFacet facet{face_opposite(tetrahedron, corner), t};
  const auto seen_from_first = [&](BallIndex k) { return lifted_vector(balls, facet.balls[0], k); };
  if (determinant(seen_from_first(facet.balls[1]), seen_from_first(facet.balls[2]),
                  seen_from_first(tetrahedron[corner])) > 0) {
    std::swap(facet.balls[1], facet.balls[2]);
  }
  return facet;
}

}  // namespace

void set_hull(const BallSet& balls, const std::vector<OutsideFace>& outside,
              Triangulation& result) {
  std::vector<std::pair<HullFacet, int>> facets;
  facets.reserve(outside.size());
  for (const auto& [t, corner] : outside) {
    facets.emplace_back(hull_facet(balls, t, result.tetrahedra[t], corner), corner);
  }
  std::sort(facets.begin(), facets.end(),
            [](const auto& a, const auto& b) { return a.first.ascending() < b.first.ascending(); });
  result.hull.reserve(facets.size());
  for (const auto& [facet, corner] : facets) {
    const auto index = static_cast<std::uint32_t>(result.hull.size());
    result.neighbours[facet.tetrahedron][corner] = Neighbour::hull_facet(index);
    result.hull.push_back(facet);
  }
}

void set_tetrahedra(const BallSet& balls, const UnorderedTetrahedra& unordered,
                    const CancelToken& cancel, Triangulation& result) {
  const std::size_t count = unordered.tetrahedra.size();
  require_at_most(count, Neighbour::kMostIndex, "tetrahedra");
  const ResultArray<Record> records = sorted_records(unordered.tetrahedra, balls.size(), cancel);
  ResultArray<std::uint32_t> after(count);  // new index, by index in the given order
  result.tetrahedra.resize(count);
  result.neighbours.resize(count);
  constexpr std::size_t kGrain = 1 << 14;
  parallel_ranges(0, static_cast<std::uint32_t>(count), kGrain,
                  [&](std::uint32_t first, std::uint32_t end) {
                    for (std::uint32_t t = first; t != end; ++t) {
                      result.tetrahedra[t] = records[t].balls;
                      after[records[t].before] = t;
                    }
                  });
  cancel.throw_if_cancelled();
  std::vector<OutsideFace> outside;
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto& across = unordered.neighbours[records[t].before];
    for (int corner = 0; corner < 4; ++corner) {
      if (across[corner] == UnorderedTetrahedra::kOutside) {
        outside.push_back({t, corner});
      } else {
        result.neighbours[t][corner] = Neighbour::tetrahedron(after[across[corner]]);
      }
    }
  }
  cancel.throw_if_cancelled();
  set_hull(balls, outside, result);
}

}  // namespace alphascope
