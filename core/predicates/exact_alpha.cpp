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

// Returns body(simplex), with the lifted simplex.
template <class Body>
auto with_lifted(const BallSet& balls, std::span<const BallIndex> simplex, const Body& body) {
  switch (simplex.size()) {
    case 1:
      return body(lift<1>(balls, simplex));
    case 2:
      return body(lift<2>(balls, simplex));
    case 3:
      return body(lift<3>(balls, simplex));
    default:
      return body(lift<4>(balls, simplex));
  }
}

}  // namespace

int compare_ortho_radius(const BallSet& balls, std::span<const BallIndex> simplex,
                         const LatticeAlpha& alpha_on_lattice) {
  return with_lifted(balls, simplex,
                     [&](const auto& s) { return compare_rho(s, alpha_on_lattice); });
}

int compare_ortho_radii(const BallSet& balls, std::span<const BallIndex, 4> a,
                        std::span<const BallIndex, 4> b) {
  return compare_exact(exact_rho(lift<4>(balls, a)), exact_rho(lift<4>(balls, b)));
}

float ortho_radius_rounded(const BallSet& balls, std::span<const BallIndex> simplex) {
  return with_lifted(balls, simplex, [](const auto& s) { return rounded_rho(s); });
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
    return with_lifted(balls, simplex, [](const auto& s) { return exact_rho(s); });
  };
  return compare_exact(rho(a), rho(b));
}

}  // namespace alphascope
