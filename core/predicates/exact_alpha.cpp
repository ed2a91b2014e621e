// SPDX-License-Identifier: GPL-3.0-or-later
// Exact decisions about ortho-radii: the bracket in double precision first, then wide integers.
#include "core/predicates/exact_alpha.hpp"

#include "core/predicates/foot_predicate.hpp"

namespace alphascope {
namespace {

template <int N>
LiftedSimplex<N> lift(const BallSet& balls, std::span<const BallIndex> simplex) {
  LiftedSimplex<N> s{};
  s.weight = balls.weight(simplex[0]);
  for (int n = 0; n < N - 1; ++n) s.v[n] = lifted_vector(balls, simplex[0], simplex[n + 1]);
  return s;
}

// Returns body(bracket, exact); exact() computes rho as a fraction, and is called only if needed.
template <int N, class Body>
auto with_rho_of(const BallSet& balls, std::span<const BallIndex> simplex, const Body& body) {
  const LiftedSimplex<N> s = lift<N>(balls, simplex);
  return body(rho_bracket(s, within_bracket_limit(s)), [&] { return exact_rho(s); });
}
template <class Body>
auto with_rho(const BallSet& balls, std::span<const BallIndex> simplex, const Body& body) {
  switch (simplex.size()) {
    case 1:
      return with_rho_of<1>(balls, simplex, body);
    case 2:
      return with_rho_of<2>(balls, simplex, body);
    case 3:
      return with_rho_of<3>(balls, simplex, body);
    default:
      return with_rho_of<4>(balls, simplex, body);
  }
}

}  // namespace

int compare_ortho_radius(const BallSet& balls, std::span<const BallIndex> simplex,
                         const LatticeAlpha& alpha_on_lattice) {
  return with_rho(balls, simplex, [&](const Bracket& rho, const auto& exact) {
    const int side = compare_bracket(rho, alpha_on_lattice);
    return side != 0 ? side : compare_exact(exact(), alpha_on_lattice);
  });
}

int compare_ortho_radii(const BallSet& balls, std::span<const BallIndex, 4> a,
                        std::span<const BallIndex, 4> b) {
  return compare_exact(exact_rho(lift<4>(balls, a)), exact_rho(lift<4>(balls, b)));
}

float ortho_radius_rounded(const BallSet& balls, std::span<const BallIndex> simplex) {
  switch (simplex.size()) {
    case 1:
      return rounded_rho(lift<1>(balls, simplex));
    case 2:
      return rounded_rho(lift<2>(balls, simplex));
    case 3:
      return rounded_rho(lift<3>(balls, simplex));
    default:
      return rounded_rho(lift<4>(balls, simplex));
  }
}

int conflict_with_smallest_orthosphere(const BallSet& balls, std::span<const BallIndex> simplex,
                                       BallIndex m) {
  const BallIndex i = simplex[0];
  const LiftedInt vm = lifted_vector(balls, i, m);
  if (simplex.size() == 1) return sign_of(vm.c);
  const LiftedInt vj = lifted_vector(balls, i, simplex[1]);
  if (simplex.size() == 2) return -edge_foot_cut(vj, vm);
  return -triangle_foot_cut(vj, lifted_vector(balls, i, simplex[2]), vm);
}

int compare_ortho_radii_of(const BallSet& balls, std::span<const BallIndex> a,
                           std::span<const BallIndex> b) {
  const auto rho = [&](std::span<const BallIndex> simplex) {
    return with_rho(balls, simplex, [](const Bracket&, const auto& exact) { return exact(); });
  };
  return compare_exact(rho(a), rho(b));
}

}  // namespace alphascope
