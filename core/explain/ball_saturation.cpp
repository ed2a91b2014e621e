// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the star of the ball in a triangulation of a few balls, which has the true surroundings.
#include "core/explain/ball_saturation.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/explain/local_star.hpp"
#include "core/explain/nearest_by_power.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/rounds/thesis_rounds.hpp"
#include "core/verify/verify_orthosphere.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kFirst = 24;  // balls chosen to begin with

LocalStar star_of(const BallSet& balls, BallIndex ball, const RunContext& context) {
  const PointAtBall centre{ball, {}};
  std::vector<BallIndex> first = nearest_by_power(balls, {&centre, 1}, {&ball, 1}, kFirst).front();
  first.push_back(ball);
  return local_star(balls, {&ball, 1}, std::move(first), context);
}

template <class Simplex>
bool has(const Simplex& simplex, BallIndex ball) {
  return std::find(simplex.begin(), simplex.end(), ball) != simplex.end();
}

// The first round whose alpha is not below the ortho-radius; 0: none.
std::size_t first_round(const BallSet& balls, const std::array<BallIndex, 4>& last) {
  for (std::size_t n = 1; n <= kMostRounds; ++n) {
    const LatticeAlpha alpha = balls.lattice.alpha_on_lattice(alpha_of_round(n));
    if (compare_ortho_radius(balls, last, alpha) <= 0) return n;
  }
  return 0;
}

double rho_angstrom2(const BallSet& balls, const std::array<BallIndex, 4>& tetrahedron) {
  const ExactRho rho = Orthosphere<4>(balls, tetrahedron).rho();
  return balls.lattice.square_angstrom(rho.numerator.near_double() / rho.denominator.near_double());
}

}  // namespace

BallSaturation ball_saturation(const BallSet& balls, BallIndex ball, const RunContext& context) {
  using State = BallSaturation::State;
  if (ball >= balls.size()) throw std::invalid_argument("there is no such ball");
  const LocalStar star = star_of(balls, ball, context);
  const Triangulation& around = star.triangulation;
  const BallIndex local = star.local(ball);
  BallSaturation result;
  if (around.dimension < 3) return result;
  result.state = State::hidden;
  std::optional<std::array<BallIndex, 4>> last;
  for (const auto& t : around.tetrahedra) {
    if (!has(t, local)) continue;
    ++result.tetrahedra;
    if (!last || compare_ortho_radii(*star.balls, *last, t) < 0) last = t;
  }
  if (!last) return result;
  result.state = State::on_hull;
  for (const HullFacet& facet : around.hull) {
    if (has(facet.balls, local)) return result;
  }
  result.state = State::saturates;
  std::transform(last->begin(), last->end(), result.last.begin(),
                 [&](BallIndex i) { return star.chosen[i]; });
  result.angstrom2 = rho_angstrom2(balls, result.last);
  result.round = first_round(balls, result.last);
  return result;
}

}  // namespace alphascope
