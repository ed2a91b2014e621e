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
        outside.push_back({t, corner, result.tetrahedra[t]});
      } else {
        result.neighbours[t][corner] = Neighbour::tetrahedron(after[across[corner]]);
      }
    }
  }
  cancel.throw_if_cancelled();
  set_hull(hull_facets(balls, outside), outside, result);
}

}  // namespace alphascope
