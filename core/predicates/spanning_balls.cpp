// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the spanning balls by exact cross products and determinants.
#include "core/predicates/spanning_balls.hpp"

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

namespace {

// Of `count` balls, the nth of which is ball_at(n).
template <class Index, class BallAt>
std::vector<Index> span_of(const BallSet& balls, Index first, Index count, const BallAt& ball_at) {
  std::vector<Index> span{first};
  LiftedInt j{}, k{};
  for (Index m = 0; m < count && span.size() < 4; ++m) {
    const LiftedInt v = lifted_vector(balls, ball_at(first), ball_at(m));
    const auto n = cross(j, v);
    const bool beyond = span.size() == 1   ? v.x != 0 || v.y != 0 || v.z != 0
                        : span.size() == 2 ? n.x != 0 || n.y != 0 || n.z != 0
                                           : determinant(j, k, v) != 0;
    if (!beyond) continue;
    (span.size() == 1 ? j : k) = v;
    span.push_back(m);
  }
  return span;
}

}  // namespace

std::vector<BallIndex> spanning_balls(const BallSet& balls, BallIndex first) {
  return span_of(balls, first, static_cast<BallIndex>(balls.size()), [](BallIndex n) { return n; });
}

std::vector<std::size_t> spanning_balls(const BallSet& balls, std::span<const BallIndex> some) {
  if (some.empty()) return {};
  return span_of(balls, std::size_t{0}, some.size(), [&](std::size_t n) { return some[n]; });
}

int dimension_of_centres(const BallSet& balls) {
  return balls.size() == 0 ? -1 : static_cast<int>(spanning_balls(balls, 0).size()) - 1;
}

}  // namespace alphascope
