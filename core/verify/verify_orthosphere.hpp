// SPDX-License-Identifier: GPL-3.0-or-later
// Decides from the definition whether a simplex is in the regular triangulation, in integers
// without any floating point: its orthosphere, the balls in conflict with it, and the ties.
//
// Ties are broken as CGAL does (perturbation.hpp): the weights are w - e, where the e of a ball
// whose centre comes later in lexicographic order is infinitely larger. Let x be the orthocentre of
// a simplex s of the balls v, and let ball m have exactly the same power there.
//  - m in the affine hull of s: p_m = sum of lambda_v p_v with sum 1. Where the perturbed balls of
//    s have equal power, that of m exceeds theirs by e_m - sum of lambda_v e_v. The last ball in
//    this expression decides: m destroys s iff that ball is a v with lambda_v > 0.
//  - m beside the hull: all balls of this power at x, the ties, span a polytope of higher
//  dimension.
//    The perturbation cuts it into simplices, all with the same orthosphere. A simplex of lower
//    dimension than the polytope is in the triangulation iff it is a face of one of the next
//    dimension. So the ties are joined to it one by one.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/geometry/real_point.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

enum class Tie { harmless, destroys, beside };

// The orthosphere of N balls, with positions relative to the first ball: 2 x D = n, D > 0. Bits,
// with |d_x| < 2^30 and |c| < 2^63: n has at most 156, D 124 (both for a triangle), so a side has
// 189.
template <int N>
class Orthosphere {
 public:
  using Wide = WideInt<4>;

  Orthosphere(const BallSet& balls, const std::array<BallIndex, N>& simplex)
      : balls_(balls), simplex_(simplex) {
    for (int v = 1; v < N; ++v) edge_[v - 1] = lifted_vector(balls, simplex[0], simplex[v]);
    solve();
  }

  // True if the balls are affinely dependent; there is no orthosphere then.
  bool flat() const { return d_.sign() == 0; }

  // Sign of the power of ball m at the orthocentre minus rho: negative is a conflict, 0 a tie. With
  // d and c of m as in core/predicates/lifted.hpp, it is the sign of c D - d·n.
  int side(BallIndex m) const {
    const LiftedInt v = lifted_vector(balls_, simplex_[0], m);
    return (d_.times(v.c) - n_.x.times(v.x) - n_.y.times(v.y) - n_.z.times(v.z)).sign();
  }

  // The same as numbers, within one part in 2^49. excess(): the power of ball m at the orthocentre
  // minus rho, square lattice units. from_first_ball(): the orthocentre relative to the first
  // ball's centre, lattice units.
  double excess(BallIndex m) const {
    const LiftedInt v = lifted_vector(balls_, simplex_[0], m);
    return (d_.times(v.c) - n_.x.times(v.x) - n_.y.times(v.y) - n_.z.times(v.z)).near_double() /
           d_.near_double();
  }
  RealPoint from_first_ball() const {
    const double twice = 2 * d_.near_double();
    return {n_.x.near_double() / twice, n_.y.near_double() / twice, n_.z.near_double() / twice};
  }

  ExactRho rho() const {
    const std::int64_t weight = balls_.weight(simplex_[0]);
    if constexpr (N == 1) return exact_vertex_rho(weight);
    if constexpr (N == 2) return exact_edge_rho(edge_[0], weight);
    if constexpr (N == 3) return exact_triangle_rho(edge_[0], edge_[1], weight);
    if constexpr (N == 4) return exact_tetrahedron_rho(edge_[0], edge_[1], edge_[2], weight);
  }

  // The effect of a ball m with side(m) = 0.
  Tie tie(BallIndex m) const {
    std::array<Int128, N> lambda;  // times a positive number
    if (!coordinates(lifted_vector(balls_, simplex_[0], m), lambda)) return Tie::beside;
    BallIndex last = m;
    bool destroys = false;
    for (int v = 0; v < N; ++v) {
      if (lambda[v] == 0 || balls_.centres[simplex_[v]] < balls_.centres[last]) continue;
      last = simplex_[v];
      destroys = lambda[v] > 0;
    }
    return destroys ? Tie::destroys : Tie::harmless;
  }

 private:
  void solve() {
    if constexpr (N == 1) {
      n_ = {Wide(0), Wide(0), Wide(0)};
      d_ = Wide(1);
    } else if constexpr (N == 2) {
      const LiftedInt& j = edge_[0];
      n_ = {Wide(j.x).times(j.c), Wide(j.y).times(j.c), Wide(j.z).times(j.c)};
      d_ = Wide(dot(j, j));
    } else if constexpr (N == 3) {
      const LiftedInt &j = edge_[0], &k = edge_[1];
      const auto normal = cross(j, k);
      const auto combined = [&](std::int64_t of_j, std::int64_t of_k) {
        return Wide(of_k).times(j.c) - Wide(of_j).times(k.c);
      };
      const Wide x = combined(j.x, k.x), y = combined(j.y, k.y), z = combined(j.z, k.z);
      n_ = {y.times(normal.z) - z.times(normal.y), z.times(normal.x) - x.times(normal.z),
            x.times(normal.y) - y.times(normal.x)};
      d_ = Wide(normal.x).times(normal.x) + Wide(normal.y).times(normal.y) +
           Wide(normal.z).times(normal.z);
    } else {
      const LiftedInt &j = edge_[0], &k = edge_[1], &l = edge_[2];
      const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
      const auto combined = [&](std::int64_t of_j, std::int64_t of_k, std::int64_t of_l) {
        return Wide(of_j).times(j.c) + Wide(of_k).times(k.c) + Wide(of_l).times(l.c);
      };
      n_ = {combined(kl.x, lj.x, jk.x), combined(kl.y, lj.y, jk.y), combined(kl.z, lj.z, jk.z)};
      d_ = Wide(kl.x).times(j.x) + Wide(kl.y).times(j.y) + Wide(kl.z).times(j.z);
      if (d_.sign() < 0) {
        d_ = -d_;
        n_ = {-n_.x, -n_.y, -n_.z};
      }
    }
  }

  // Barycentric coordinates of m in the simplex, times a positive number. False if m is not in the
  // affine hull of the simplex.
  bool coordinates(const LiftedInt& m, std::array<Int128, N>& lambda) const {
    Int128 whole = 0;
    if constexpr (N == 1) {
      return false;  // no other ball has this centre
    } else if constexpr (N == 2) {
      const auto away = cross(edge_[0], m);
      if (away.x != 0 || away.y != 0 || away.z != 0) return false;
      whole = dot(edge_[0], edge_[0]);
      lambda[1] = dot(edge_[0], m);
    } else if constexpr (N == 3) {
      const LiftedInt &j = edge_[0], &k = edge_[1];
      if (determinant(j, k, m) != 0) return false;
      const auto normal = cross(j, k);
      const auto along_normal = [&](const Vector3<std::int64_t>& v) {
        return Int128{v.x} * normal.x + Int128{v.y} * normal.y + Int128{v.z} * normal.z;
      };
      whole = along_normal(normal);
      lambda[1] = along_normal(cross(m, k));
      lambda[2] = along_normal(cross(j, m));
    } else {
      const LiftedInt &j = edge_[0], &k = edge_[1], &l = edge_[2];
      whole = determinant(j, k, l);
      const int sign = whole < 0 ? -1 : 1;
      whole *= sign;
      lambda[1] = determinant(m, k, l) * sign;
      lambda[2] = determinant(j, m, l) * sign;
      lambda[3] = determinant(j, k, m) * sign;
    }
    lambda[0] = whole;
    for (int v = 1; v < N; ++v) lambda[0] -= lambda[v];
    return true;
  }

  const BallSet& balls_;
  std::array<BallIndex, N> simplex_;
  std::array<LiftedInt, 3> edge_;  // the first N - 1 are used: lifted vectors of the other balls
  Wide d_;
  Vector3<Wide> n_;
};

// The simplex with one more ball, ascending.
template <int N>
std::array<BallIndex, N + 1> joined(const std::array<BallIndex, N>& simplex, BallIndex m) {
  std::array<BallIndex, N + 1> larger;
  std::copy(simplex.begin(), simplex.end(), larger.begin());
  larger[N] = m;
  std::sort(larger.begin(), larger.end());
  return larger;
}

// Is a simplex without a ball in conflict in the triangulation? `ties` are all other balls with
// side 0.
template <int N>
bool in_triangulation(const BallSet& balls, const std::array<BallIndex, N>& simplex,
                      const std::vector<BallIndex>& ties) {
  const Orthosphere<N> sphere(balls, simplex);
  std::vector<BallIndex> beside;
  for (const BallIndex m : ties) {
    if (std::find(simplex.begin(), simplex.end(), m) != simplex.end()) continue;
    const Tie tie = sphere.tie(m);
    if (tie == Tie::destroys) return false;
    if (tie == Tie::beside) beside.push_back(m);
  }
  if (beside.empty()) return true;
  if constexpr (N < 4) {
    return std::any_of(beside.begin(), beside.end(), [&](BallIndex m) {
      return in_triangulation<N + 1>(balls, joined<N>(simplex, m), beside);
    });
  }
  return false;  // not reached, since no ball is beside the hull of four balls
}

}  // namespace alphascope
