// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether another ball cuts off the orthocentre of an edge or triangle: the foot of ball
// i's centre on the radical plane or line. The simplex is attached iff some ball does. Host and
// device; notation and bounds of lifted.hpp.
#pragma once

#include "core/predicates/orthosphere.hpp"

namespace alphascope {

// Sign of 2 d_m·x - c_m at the foot x of edge ij: +1 where m has the smaller power distance.
// x = d_j c_j / (2 |d_j|²), so the sign is that of (d_m·d_j) c_j - c_m |d_j|². Bits: 62 + 63.
ALPHASCOPE_HOST_DEVICE inline int edge_foot_cut_filtered(const LiftedVector<double>& j,
                                                         const LiftedVector<double>& m) {
  const double a = dot(m, j) * j.c, b = m.c * dot(j, j);
  // Within kBracketLimit the dot products are exact. Each product has one rounding, and so has the
  // difference.
  const double difference = a - b;
  const double error = 3 * kUnitRoundoff * (std::fabs(a) + std::fabs(b));
  return difference > error ? 1 : difference < -error ? -1 : 0;
}
ALPHASCOPE_HOST_DEVICE inline int edge_foot_cut_exact(const LiftedInt& j, const LiftedInt& m) {
  const auto a = lifted_as<WideInt<4>>(j), b = lifted_as<WideInt<4>>(m);
  return (dot(b, a) * a.c - b.c * dot(a, a)).sign();
}
ALPHASCOPE_HOST_DEVICE inline int edge_foot_cut(const LiftedInt& j, const LiftedInt& m) {
  if (within_bracket_limit(j) && within_bracket_limit(m)) {
    const int side = edge_foot_cut_filtered(lifted_as<double>(j), lifted_as<double>(m));
    if (side != 0) return side;
  }
  return edge_foot_cut_exact(j, m);
}

// The same for all edges of triangle ijk, each with the ball that it lacks: cut[0] is of edge jk,
// cut[1] of ik, cut[2] of ij. 0 where doubles do not decide. `jk` is the vector from j to k. It and
// both arguments must be within kBracketLimit. So all but the products and differences is exact.
ALPHASCOPE_HOST_DEVICE inline void edge_foot_cuts_filtered(const LiftedVector<double>& j,
                                                           const LiftedVector<double>& k,
                                                           const Vector3<double>& jk,
                                                           signed char (&cut)[3]) {
  const auto side = [](double a, double b) -> signed char {
    const double difference = a - b, error = 3 * kUnitRoundoff * (std::fabs(a) + std::fabs(b));
    return difference > error ? 1 : difference < -error ? -1 : 0;
  };
  const double length_j = dot(j, j), length_k = dot(k, k), length_jk = dot(jk, jk);
  const double both = dot(j, k);
  // Seen from j, i and k have these c.
  const double i_from_j = length_j + (length_j - j.c);
  const double k_from_j = length_jk + ((k.c - length_k) - (j.c - length_j));
  cut[2] = side(both * j.c, k.c * length_j);
  cut[1] = side(both * k.c, j.c * length_k);
  cut[0] = side((length_j - both) * k_from_j, i_from_j * length_jk);
}

// Sign of 2 d_m·x - c_m at the foot x of triangle ijk: x = v × n / (2 |n|²), v = c_j d_k - c_k d_j,
// n = d_j × d_k. Bits: 3-term sums of 31 + 160, and 63 + 128.
ALPHASCOPE_HOST_DEVICE inline int triangle_foot_cut_filtered(const LiftedVector<double>& j,
                                                             const LiftedVector<double>& k,
                                                             const LiftedVector<double>& m) {
  const auto n = cross(j, k);  // exact
  const Vector3<double> v{j.c * k.x - k.c * j.x, j.c * k.y - k.c * j.y, j.c * k.z - k.c * j.z};
  const Vector3<double> v_size{std::fabs(j.c * k.x) + std::fabs(k.c * j.x),
                               std::fabs(j.c * k.y) + std::fabs(k.c * j.y),
                               std::fabs(j.c * k.z) + std::fabs(k.c * j.z)};
  const Vector3<double> n_size{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const auto x = cross(v, n);
  const double a = m.x * x.x + m.y * x.y + m.z * x.z, b = m.c * dot(n, n);
  // `size` is the sum of the absolute values of all products; each carries at most 8 roundings.
  const double size = std::fabs(m.x) * (v_size.y * n_size.z + v_size.z * n_size.y) +
                      std::fabs(m.y) * (v_size.z * n_size.x + v_size.x * n_size.z) +
                      std::fabs(m.z) * (v_size.x * n_size.y + v_size.y * n_size.x) + std::fabs(b);
  const double error = 12 * kUnitRoundoff * size;
  const double difference = a - b;
  return difference > error ? 1 : difference < -error ? -1 : 0;
}
ALPHASCOPE_HOST_DEVICE inline int triangle_foot_cut_exact(const LiftedInt& j, const LiftedInt& k,
                                                          const LiftedInt& m) {
  const auto a = lifted_as<WideInt<4>>(j), b = lifted_as<WideInt<4>>(k),
             e = lifted_as<WideInt<4>>(m);
  const auto n = cross(a, b);
  const Vector3<WideInt<4>> v{a.c * b.x - b.c * a.x, a.c * b.y - b.c * a.y, a.c * b.z - b.c * a.z};
  return (dot(e, cross(v, n)) - e.c * dot(n, n)).sign();
}
ALPHASCOPE_HOST_DEVICE inline int triangle_foot_cut(const LiftedInt& j, const LiftedInt& k,
                                                    const LiftedInt& m) {
  if (within_bracket_limit(j) && within_bracket_limit(k) && within_bracket_limit(m)) {
    const int side = triangle_foot_cut_filtered(lifted_as<double>(j), lifted_as<double>(k),
                                                lifted_as<double>(m));
    if (side != 0) return side;
  }
  return triangle_foot_cut_exact(j, k, m);
}

}  // namespace alphascope
