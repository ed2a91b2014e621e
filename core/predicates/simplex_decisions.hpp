// SPDX-License-Identifier: GPL-3.0-or-later
// Decides for an edge, triangle or tetrahedron of ball i and its neighbours whether rho <= alpha,
// and with which alpha value. Decides as well whether an edge is attached. One template body serves
// the CPU and the CUDA executor, filtered or exact.
//
// The neighbours of a ball suffice: balls outside N_alpha(i) cut off only points with pi_i > alpha,
// and every simplex of K_alpha has its witness where pi_i <= alpha (docs/algorithm.md).
#pragma once

#include "core/predicates/foot_predicate.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

enum class Decision : signed char { out = -1, unknown = 0, in = 1 };

// Filter first, then exact integers where the filter does not decide. Never `unknown`.
struct ExactDecider {
  static constexpr bool kExact = true;
};
// Filter only. A ball with an `unknown` decision goes to the exact kernel.
struct FilteredDecider {
  static constexpr bool kExact = false;
};

// Is rho <= alpha? If so, and if `rounded` is not null, *rounded becomes the float nearest to rho.
template <class Decider, int N>
ALPHASCOPE_INLINE Decision decide_rho(const LiftedSimplex<N>& s, bool brackets_hold,
                                      const LatticeAlpha& alpha, float* rounded) {
  const Bracket rho = rho_bracket(s, brackets_hold);
  const int side = compare_bracket(rho, alpha);
  if (side > 0) return Decision::out;
  if (side < 0 && (rounded == nullptr || round_bracket(rho, rounded))) return Decision::in;
  if constexpr (!Decider::kExact) {
    return Decision::unknown;
  } else {
    const ExactRho value = exact_rho(s);
    if (side == 0 && compare_exact(value, alpha) > 0) return Decision::out;
    if (rounded != nullptr) *rounded = round_exact(value);
    return Decision::in;
  }
}

// Ball i and its neighbours. A neighbour is named by its slot in the list.
template <class Neighbours>
struct Neighbourhood {
  const Neighbours& neighbours;  // .lifted(slot) -> LiftedInt
  std::int64_t weight;           // of ball i, square lattice units
  const LatticeAlpha* alpha;     // must outlive this object
  std::int64_t ghost_reach;      // > sqrt(weight + alpha)
  bool brackets_hold;            // all slots are within kBracketLimit
};

// Decides rho <= alpha for ball i and one to three neighbours.
template <class Decider, class Neighbours, class... Slots>
ALPHASCOPE_INLINE Decision decide_simplex(const Neighbourhood<Neighbours>& in, float* rounded,
                                          Slots... slots) {
  const LiftedSimplex<1 + sizeof...(Slots)> s{{in.neighbours.lifted(slots)...}, in.weight};
  return decide_rho<Decider>(s, in.brackets_hold, *in.alpha, rounded);
}

// Does ball m cut off the orthocentre of edge ij? Then ij is attached: it is in K_alpha iff one of
// its triangles is, with the least of their alpha values. A tie with a ball beside the line ij
// counts as a cut (EdgeTie).
template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision edge_attached_to(const Neighbourhood<Neighbours>& in, int j, int m) {
  const LiftedInt vj = in.neighbours.lifted(j), vm = in.neighbours.lifted(m);
  int side =
      in.brackets_hold ? edge_foot_cut_filtered(lifted_as<double>(vj), lifted_as<double>(vm)) : 0;
  if (side == 0) {
    if constexpr (!Decider::kExact) return Decision::unknown;
    side = edge_foot_cut_exact(vj, vm);
    if (side == 0) side = edge_tie(vj, vm) == EdgeTie::outside ? -1 : 1;
  }
  return side > 0 ? Decision::in : Decision::out;
}

// Does the ball or ghost plane m cut off the orthocentre of triangle ijk? A tie does not matter,
// since the tetrahedron then has the same alpha value.
template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision triangle_cut_by(const Neighbourhood<Neighbours>& in, int j, int k,
                                           const LiftedInt& vm) {
  const LiftedInt vj = in.neighbours.lifted(j), vk = in.neighbours.lifted(k);
  int side = in.brackets_hold
                 ? triangle_foot_cut_filtered(lifted_as<double>(vj), lifted_as<double>(vk),
                                              lifted_as<double>(vm))
                 : 0;
  if (side == 0) {
    if constexpr (!Decider::kExact) return Decision::unknown;
    side = triangle_foot_cut_exact(vj, vk, vm);
  }
  return side > 0 ? Decision::in : Decision::out;
}

}  // namespace alphascope
