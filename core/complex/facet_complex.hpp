// What a finished facet polygon P_ij says about K_alpha: the edge ij, the triangles ijk on its
// sides and the tetrahedra ijkl at its corners, with alpha values and classes. One template body
// for the CPU and the CUDA executor; how the polygon was cut is facet_polygon.hpp's business.
//
// Why a local polygon suffices: it may lack cuts by balls outside N_alpha(i), but those only remove
// points of pi_i > alpha. So wherever pi_i <= alpha the polygon is the true facet, and every
// simplex of K_alpha has its witness there (docs/algorithm.md).
#pragma once

#include "core/complex/facet_polygon.hpp"
#include "core/geometry/foot_predicate.hpp"

namespace alphascope {

enum class Decision : signed char { out = -1, unknown = 0, in = 1 };

// Filter first, exact integers where the filter does not decide: always an answer.
struct ExactDecider {
  static constexpr bool kExact = true;
};
// Filter only: `unknown` sends the facet to the exact kernel.
struct FilteredDecider {
  static constexpr bool kExact = false;
};

// Is rho <= alpha? And its nearest float, when it is and `rounded` is not null. `exact` is called
// on demand.
template <class Decider, class Exact>
ALPHASCOPE_INLINE Decision decide_rho(const Bracket& rho, double alpha, float* rounded,
                                      const Exact& exact) {
  const int side = compare_bracket(rho, alpha);
  if (side > 0) return Decision::out;
  if (side < 0 && (rounded == nullptr || round_bracket(rho, rounded))) return Decision::in;
  if constexpr (!Decider::kExact) {
    return Decision::unknown;
  } else {
    const ExactRho value = exact();
    if (side == 0 && compare_exact(value, alpha) > 0) return Decision::out;
    if (rounded != nullptr) *rounded = round_exact(value);
    return Decision::in;
  }
}

// A facet's surroundings: balls are named by their slot in the neighbour list of ball i.
template <class Neighbours>
struct FacetInput {
  const Neighbours& neighbours;  // .lifted(slot) -> LiftedInt, .ball(slot) -> BallIndex
  int j;                         // slot of ball j
  std::int64_t weight;           // of ball i, square lattice units
  double alpha;                  // square lattice units
  std::int64_t ghost_reach;      // > sqrt(weight + alpha)
  bool brackets_hold;            // all slots are within kBracketLimit

  ALPHASCOPE_INLINE LiftedInt side_vector(int id, int axis) const {
    return id < 0 ? ghost_vector(id, axis, ghost_reach) : neighbours.lifted(id);
  }
};

template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision decide_edge(const FacetInput<Neighbours>& in, float* rounded) {
  const LiftedInt j = in.neighbours.lifted(in.j);
  const Bracket rho = in.brackets_hold
                          ? edge_rho(lifted_as<double>(j), static_cast<double>(in.weight))
                          : Bracket{0, HUGE_VAL};
  return decide_rho<Decider>(rho, in.alpha, rounded, [&] { return exact_edge_rho(j, in.weight); });
}

template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision decide_triangle(const FacetInput<Neighbours>& in, int k,
                                           float* rounded) {
  const LiftedInt j = in.neighbours.lifted(in.j), vk = in.neighbours.lifted(k);
  const Bracket rho = in.brackets_hold ? triangle_rho(lifted_as<double>(j), lifted_as<double>(vk),
                                                      static_cast<double>(in.weight))
                                       : Bracket{0, HUGE_VAL};
  return decide_rho<Decider>(rho, in.alpha, rounded,
                             [&] { return exact_triangle_rho(j, vk, in.weight); });
}

template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision decide_tetrahedron(const FacetInput<Neighbours>& in, int k, int l,
                                              float* rounded) {
  const LiftedInt j = in.neighbours.lifted(in.j), vk = in.neighbours.lifted(k),
                  vl = in.neighbours.lifted(l);
  const Bracket rho = in.brackets_hold
                          ? tetrahedron_rho(lifted_as<double>(j), lifted_as<double>(vk),
                                            lifted_as<double>(vl), static_cast<double>(in.weight))
                          : Bracket{0, HUGE_VAL};
  return decide_rho<Decider>(rho, in.alpha, rounded,
                             [&] { return exact_tetrahedron_rho(j, vk, vl, in.weight); });
}

// Does ball (or ghost) m cut off the orthocentre of edge ij / triangle ijk? +1, 0 or -1, where 0
// from the filter means unknown, and from the exact test a tie (the value is then the same either
// way).
template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision edge_cut_by(const FacetInput<Neighbours>& in, int m) {
  const LiftedInt j = in.neighbours.lifted(in.j), vm = in.neighbours.lifted(m);
  int side =
      in.brackets_hold ? edge_foot_cut_filtered(lifted_as<double>(j), lifted_as<double>(vm)) : 0;
  if (side == 0) {
    if constexpr (!Decider::kExact) return Decision::unknown;
    side = edge_foot_cut_exact(j, vm);
  }
  return side > 0 ? Decision::in : Decision::out;
}

template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision triangle_cut_by(const FacetInput<Neighbours>& in, int k,
                                           const LiftedInt& vm) {
  const LiftedInt j = in.neighbours.lifted(in.j), vk = in.neighbours.lifted(k);
  int side = in.brackets_hold
                 ? triangle_foot_cut_filtered(lifted_as<double>(j), lifted_as<double>(vk),
                                              lifted_as<double>(vm))
                 : 0;
  if (side == 0) {
    if constexpr (!Decider::kExact) return Decision::unknown;
    side = triangle_foot_cut_exact(j, vk, vm);
  }
  return side > 0 ? Decision::in : Decision::out;
}

// Classes as numbers, so that this header needs no host type: 0 singular, 1 regular, 2 interior.
struct FacetScratch {
  signed char* corner_in = nullptr;  // per corner: Decision of its tetrahedron (out for ghosts)
  float* corner_value = nullptr;
};

// The triangle ijk on side s: in K_alpha? Attached to the corner beyond which its orthocentre lies.
template <class Decider, class Neighbours, class Polygon>
ALPHASCOPE_INLINE Decision side_triangle(const FacetInput<Neighbours>& in, const Polygon& p,
                                         int axis, const FacetScratch& scratch, int s,
                                         float* value) {
  const int n = p.size, before = s == 0 ? n - 1 : s - 1, after = s + 1 == n ? 0 : s + 1;
  const int ends[2] = {before, s};  // corners
  const int cutters[2] = {p.id(before), p.id(after)};
  for (int e = 0; e < 2; ++e) {
    const Decision cut = triangle_cut_by<Decider>(in, p.id(s), in.side_vector(cutters[e], axis));
    if (cut == Decision::unknown) return Decision::unknown;
    if (cut == Decision::in) {
      *value = scratch.corner_value[ends[e]];
      return static_cast<Decision>(scratch.corner_in[ends[e]]);
    }
  }
  return decide_triangle<Decider>(in, p.id(s), value);
}

// The whole story of a facet whose edge has rho <= alpha (edge_value is its nearest float): calls
// sink.edge(value, class), sink.triangle(k_slot, value, class), sink.tetrahedron(k, l, value), the
// latter two only for vertices after j. Returns false when a decision is unknown.
template <class Decider, class Neighbours, class Polygon, class Sink>
ALPHASCOPE_INLINE bool report_facet(const FacetInput<Neighbours>& in, const Polygon& p, int axis,
                                    float edge_value, const FacetScratch& scratch, Sink& sink) {
  const int n = p.size;
  const auto ball_j = in.neighbours.ball(in.j);
  bool all_corners_in = true;
  for (int s = 0; s < n; ++s) {
    const int k = p.id(s), l = p.id(s + 1 == n ? 0 : s + 1);
    Decision d = Decision::out;
    if (k >= 0 && l >= 0) {
      d = decide_tetrahedron<Decider>(in, k, l, &scratch.corner_value[s]);
      if (d == Decision::unknown) return false;
      if (d == Decision::in && in.neighbours.ball(k) > ball_j && in.neighbours.ball(l) > ball_j) {
        sink.tetrahedron(k, l, scratch.corner_value[s]);
      }
    }
    scratch.corner_in[s] = static_cast<signed char>(d);
    all_corners_in = all_corners_in && d == Decision::in;
  }

  bool attached = false, any_triangle = false;
  float attached_value = 0;
  for (int s = 0; s < n; ++s) {
    const int k = p.id(s);
    if (k < 0) continue;
    const Decision cut = edge_cut_by<Decider>(in, k);
    if (cut == Decision::unknown) return false;
    attached = attached || cut == Decision::in;
    float value = 0;
    const Decision d = side_triangle<Decider>(in, p, axis, scratch, s, &value);
    if (d == Decision::unknown) return false;
    if (d != Decision::in) continue;
    if (!any_triangle || value < attached_value) attached_value = value;
    any_triangle = true;
    if (in.neighbours.ball(k) > ball_j) {
      const int cofaces =
          (scratch.corner_in[s] == 1) + (scratch.corner_in[s == 0 ? n - 1 : s - 1] == 1);
      sink.triangle(k, value, cofaces);
    }
  }
  if (attached && !any_triangle) return true;  // its nearest point lies beyond alpha
  sink.edge(attached ? attached_value : edge_value, !any_triangle ? 0 : all_corners_in ? 2 : 1);
  return true;
}

}  // namespace alphascope
