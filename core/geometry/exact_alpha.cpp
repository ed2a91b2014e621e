#include "core/geometry/exact_alpha.hpp"

#include "core/geometry/foot_predicate.hpp"

namespace alphascope {
namespace {

struct LiftedSimplex {
  int others;  // balls beside the first
  LiftedInt v[3];
  std::int64_t weight;
};

LiftedSimplex lift(const BallSet& balls, std::span<const BallIndex> simplex) {
  LiftedSimplex s{static_cast<int>(simplex.size()) - 1, {}, balls.weight(simplex[0])};
  for (int n = 0; n < s.others; ++n) s.v[n] = lifted_vector(balls, simplex[0], simplex[n + 1]);
  return s;
}

Bracket bracket(const LiftedSimplex& s) {
  for (int n = 0; n < s.others; ++n) {
    if (!within_bracket_limit(s.v[n])) return {0, HUGE_VAL};
  }
  const double weight = static_cast<double>(s.weight);
  LiftedVector<double> v[3];
  for (int n = 0; n < s.others; ++n) v[n] = lifted_as<double>(s.v[n]);
  switch (s.others) {
    case 0:
      return {-weight, 0};
    case 1:
      return edge_rho(v[0], weight);
    case 2:
      return triangle_rho(v[0], v[1], weight);
    default:
      return tetrahedron_rho(v[0], v[1], v[2], weight);
  }
}

ExactRho exact(const LiftedSimplex& s) {
  switch (s.others) {
    case 0:
      return exact_vertex_rho(s.weight);
    case 1:
      return exact_edge_rho(s.v[0], s.weight);
    case 2:
      return exact_triangle_rho(s.v[0], s.v[1], s.weight);
    default:
      return exact_tetrahedron_rho(s.v[0], s.v[1], s.v[2], s.weight);
  }
}

}  // namespace

int compare_ortho_radius(const BallSet& balls, std::span<const BallIndex> simplex,
                         double alpha_on_lattice) {
  const LiftedSimplex s = lift(balls, simplex);
  const int side = compare_bracket(bracket(s), alpha_on_lattice);
  return side != 0 ? side : compare_exact(exact(s), alpha_on_lattice);
}

float ortho_radius_rounded(const BallSet& balls, std::span<const BallIndex> simplex) {
  const LiftedSimplex s = lift(balls, simplex);
  float rounded = 0;
  return round_bracket(bracket(s), &rounded) ? rounded : round_exact(exact(s));
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

}  // namespace alphascope
