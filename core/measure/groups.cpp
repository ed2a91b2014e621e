// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components, sums by group and areas of single balls.
#include <stdexcept>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/measure/union_measures.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
Components components(std::size_t balls, const AlphaComplex& complex) {
  UnionFind sets(balls);  // roots are the lowest balls
  for (const auto& [i, j] : complex.edges.simplices) sets.unite(i, j);
  Components of;
  of.of_ball.assign(balls, kNoGroup);
  for (const auto& [i] : complex.vertices.simplices) {
    const BallIndex root = sets.root(i);
    of.of_ball[i] = root == i ? of.count++ : of.of_ball[root];
  }
  return of;
}

std::vector<double> sums_by_group(std::span<const double> values,
                                  std::span<const std::uint32_t> group, std::size_t groups) {
  if (values.size() != group.size()) {
    throw std::invalid_argument("sums by group need one group for each value");
  }
  std::vector<NeumaierSum> sums(groups);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (group[i] == kNoGroup) continue;
    if (group[i] >= groups) throw std::invalid_argument("sums by group: no such group");
    sums[group[i]].add(values[i]);
  }
  std::vector<double> totals;
  totals.reserve(groups);
  for (const NeumaierSum& sum : sums) totals.push_back(sum.value());
  return totals;
}

std::vector<double> free_areas_angstrom2(const BallSet& balls,
                                         const LatticeAlpha& alpha_on_lattice) {
  const double unit = balls.lattice.unit_angstrom();
  std::vector<double> areas;
  areas.reserve(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const GrownBall ball = grown_ball(balls.centres[i], balls.radii[i], alpha_on_lattice);
    areas.push_back(sphere_area(ball.grown_radius) * unit * unit);
  }
  return areas;
}

}  // namespace alphascope
