// SPDX-License-Identifier: GPL-3.0-or-later
// The orthocentre of a tuple in single precision with a certified error. It is the epsilon band of
// kernel II, proven instead of tuned: outside the band a sign is certain, and inside it integers
// decide (tuple_exact.hpp). Single precision is used because laptop GPUs have few units for double
// precision. Host and device.
//
// Notation of core/predicates/lifted.hpp, measured from the tuple's first ball: ball m has d = p_m
// - p_i and c = |d|² + w_i - w_m. The orthocentre x of a 4-tuple solves A x = b with rows d and
// entries c / 2; of a triangle the third row is its normal, with entry 0.
//
// The bound. Let X be any approximate inverse of A (here by LU), and y any approximation of x. Let
// R = I - X A and r = b - A y. Then x - y = A⁻¹ r = (I - R)⁻¹ X r. So if |R| <= t < 1 in the
// maximum norm, A is regular and |x - y| <= |X| |r| / (1 - t), with absolute values of the entries
// of X and r. Neither X nor y needs to be good. Only R and r are bounded, and these are plain sums
// of products.
//
// u = 2^-24. kU is 3 % above u, for terms of second order and the roundings of the bounds
// themselves. Differences of centres and sums of radii below 2^24 are exact. Products of such
// numbers are far from underflow and overflow. If a quotient leaves the range, its error becomes
// infinite.
#pragma once

#include "core/predicates/rounding.hpp"
#include "core/predicates/simplex_decisions.hpp"
#include "core/tuples/tuple_input.hpp"

namespace alphascope {

inline constexpr float kU = Rounding<float>::u;

// Ball m as seen from ball i, lattice units. `half` is c / 2 within half_error.
struct FloatLifted {
  float x, y, z, half, half_error;
};

ALPHASCOPE_INLINE FloatLifted float_lifted(const BallRecord& i, const BallRecord& m) {
  FloatLifted v;
  v.x = static_cast<float>(m.x - i.x);
  v.y = static_cast<float>(m.y - i.y);
  v.z = static_cast<float>(m.z - i.z);
  const float square = v.x * v.x + v.y * v.y + v.z * v.z;
  const float weights =
      static_cast<float>(i.radius - m.radius) * static_cast<float>(i.radius + m.radius);
  v.half = 0.5f * (square + weights);
  // The sum has at most four roundings on any path; half their error counts for c / 2.
  v.half_error = 2.05f * kU * (square + fabsf(weights));
  return v;
}

// The exact orthocentre lies within `error` of (x, y, z) in each coordinate, in lattice units. An
// infinite error means that nothing is known.
struct FloatCentre {
  float x, y, z, error;
};

struct FloatRow {
  float a[3], b, b_error;
};

namespace tuple_detail {

// A row of A, and the same row of the unit matrix.
struct LuRow {
  float a[3], e[3];
};

// Swaps the rows if q has the larger entry in `column`.
ALPHASCOPE_INLINE void pivot(LuRow& p, LuRow& q, int column) {
  if (!(fabsf(q.a[column]) > fabsf(p.a[column]))) return;
  const LuRow swapped = p;
  p = q;
  q = swapped;
}
ALPHASCOPE_INLINE void eliminate(const LuRow& p, LuRow& q, int column) {
  const float factor = q.a[column] / p.a[column];
  for (int c = column + 1; c < 3; ++c) q.a[c] -= factor * p.a[c];
  for (int c = 0; c < 3; ++c) q.e[c] -= factor * p.e[c];
}

// An approximate inverse: LU decomposition with partial pivoting, solved for the unit vectors.
ALPHASCOPE_INLINE void lu_inverse(const FloatRow (&rows)[3], float (&inverse)[3][3]) {
  LuRow r[3];
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) {
      r[k].a[c] = rows[k].a[c];
      r[k].e[c] = k == c ? 1.0f : 0.0f;
    }
  }
  pivot(r[0], r[1], 0);
  pivot(r[0], r[2], 0);
  eliminate(r[0], r[1], 0);
  eliminate(r[0], r[2], 0);
  pivot(r[1], r[2], 1);
  eliminate(r[1], r[2], 1);
  const float s0 = 1.0f / r[0].a[0], s1 = 1.0f / r[1].a[1], s2 = 1.0f / r[2].a[2];
  for (int c = 0; c < 3; ++c) {
    inverse[2][c] = r[2].e[c] * s2;
    inverse[1][c] = (r[1].e[c] - r[1].a[2] * inverse[2][c]) * s1;
    inverse[0][c] = (r[0].e[c] - r[0].a[1] * inverse[1][c] - r[0].a[2] * inverse[2][c]) * s0;
  }
}

}  // namespace tuple_detail

// Solves A x = b. The entries of the last row may err by last_row_error each; the other rows are
// exact.
ALPHASCOPE_INLINE FloatCentre solve_centre(const FloatRow (&rows)[3], float last_row_error) {
  float inverse[3][3], y[3], residual[3], row_sum[3];
  tuple_detail::lu_inverse(rows, inverse);
  for (int k = 0; k < 3; ++k) {
    y[k] = inverse[k][0] * rows[0].b + inverse[k][1] * rows[1].b + inverse[k][2] * rows[2].b;
  }
  const float size = fmaxf(fabsf(y[0]), fmaxf(fabsf(y[1]), fabsf(y[2])));
  for (int k = 0; k < 3; ++k) {
    const float p0 = rows[k].a[0] * y[0], p1 = rows[k].a[1] * y[1], p2 = rows[k].a[2] * y[2];
    const float terms = fabsf(rows[k].b) + fabsf(p0) + fabsf(p1) + fabsf(p2);
    // At most four roundings on any path.
    residual[k] = fabsf(((rows[k].b - p0) - p1) - p2) + 4.2f * kU * terms + 1.01f * rows[k].b_error;
    row_sum[k] = fabsf(rows[k].a[0]) + fabsf(rows[k].a[1]) + fabsf(rows[k].a[2]);
  }
  residual[2] += 3.03f * last_row_error * size;

  float largest_defect = 0, largest_step = 0;
  bool finite = true;
  for (int k = 0; k < 3; ++k) {
    const float i0 = inverse[k][0], i1 = inverse[k][1], i2 = inverse[k][2];
    float defect = 0;
    for (int c = 0; c < 3; ++c) {
      const float unit = k == c ? 1.0f : 0.0f;
      defect += fabsf(((unit - i0 * rows[0].a[c]) - i1 * rows[1].a[c]) - i2 * rows[2].a[c]);
    }
    // Each of the three entries has the same four roundings; their terms add up by row sums.
    defect +=
        4.2f * kU *
            (1.0f + fabsf(i0) * row_sum[0] + fabsf(i1) * row_sum[1] + fabsf(i2) * row_sum[2]) +
        3.03f * last_row_error * fabsf(i2);
    const float step = fabsf(i0) * residual[0] + fabsf(i1) * residual[1] + fabsf(i2) * residual[2];
    finite = finite && defect < 0.5f && step < HUGE_VALF;  // false for NaN, which fmaxf() ignores
    largest_defect = fmaxf(largest_defect, defect);
    largest_step = fmaxf(largest_step, step);
  }
  const float error = finite ? 1.02f * largest_step / (1.0f - 1.02f * largest_defect) : HUGE_VALF;
  return {y[0], y[1], y[2], error};
}

ALPHASCOPE_INLINE FloatRow centre_row(const FloatLifted& v) {
  return {{v.x, v.y, v.z}, v.half, v.half_error};
}

// Edge ij: x = d (c / 2) / |d|².
ALPHASCOPE_INLINE FloatCentre float_centre(const FloatLifted& j) {
  const float square = j.x * j.x + j.y * j.y + j.z * j.z;  // three roundings
  const float t = j.half / square;
  const float t_error = 1.05f * j.half_error / square + 5.2f * kU * fabsf(t);
  const float size = fmaxf(fabsf(j.x), fmaxf(fabsf(j.y), fabsf(j.z)));
  return {j.x * t, j.y * t, j.z * t, 1.02f * size * t_error};
}

// Triangle ijk. The normal is scaled to the size of the edges, so that LU gets a balanced matrix.
// Each of its entries is a scale times the difference of two products: at most four roundings.
ALPHASCOPE_INLINE FloatCentre float_centre(const FloatLifted& j, const FloatLifted& k) {
  const float nx = j.y * k.z - j.z * k.y, ny = j.z * k.x - j.x * k.z, nz = j.x * k.y - j.y * k.x;
  const float size_j = fmaxf(fabsf(j.x), fmaxf(fabsf(j.y), fabsf(j.z)));
  const float size_k = fmaxf(fabsf(k.x), fmaxf(fabsf(k.y), fabsf(k.z)));
  const float size_n = fmaxf(fabsf(nx), fmaxf(fabsf(ny), fabsf(nz)));
  const float scale = size_j / size_n;
  const FloatRow rows[3] = {
      centre_row(j), centre_row(k), {{nx * scale, ny * scale, nz * scale}, 0.0f, 0.0f}};
  return solve_centre(rows, scale * (8.4f * kU) * size_j * size_k);
}

ALPHASCOPE_INLINE FloatCentre float_centre(const FloatLifted& j, const FloatLifted& k,
                                           const FloatLifted& l) {
  const FloatRow rows[3] = {centre_row(j), centre_row(k), centre_row(l)};
  return solve_centre(rows, 0.0f);
}

// Is rho = |x|² - w <= alpha?
ALPHASCOPE_INLINE Decision centre_within(const FloatCentre& c, std::int32_t radius, float alpha) {
  const float r = static_cast<float>(radius), weight = r * r;
  const float square = c.x * c.x + c.y * c.y + c.z * c.z;
  const float difference = square - (weight + alpha);
  // The square has four roundings, and the limit has three, alpha's own included.
  const float margin =
      1.02f * c.error * (2.0f * (fabsf(c.x) + fabsf(c.y) + fabsf(c.z)) + 3.0f * c.error) +
      4.2f * kU * square + 3.2f * kU * (weight + fabsf(alpha));
  return difference > margin    ? Decision::out
         : difference < -margin ? Decision::in
                                : Decision::unknown;
}

// The data that all conflict tests of one centre share.
struct FloatConflict {
  float x, y, z, reach_error;

  ALPHASCOPE_INLINE explicit FloatConflict(const FloatCentre& c) : x(c.x), y(c.y), z(c.z) {
    const float size = fmaxf(fabsf(x), fmaxf(fabsf(y), fabsf(z)));
    reach_error = 1.02f * c.error + 4.2f * kU * size;  // four roundings of each product
  }
  // Has ball m less power distance at the centre than the tuple (2 d·x > c)? +1: yes, -1: no, 0:
  // not certain. half_error is 2.05 kU times a sum that is at least 2 |half|.
  ALPHASCOPE_INLINE int side(const BallRecord& i, const BallRecord& m) const {
    const FloatLifted v = float_lifted(i, m);
    const float value = (v.x * x + v.y * y + v.z * z) - v.half;
    const float margin = (fabsf(v.x) + fabsf(v.y) + fabsf(v.z)) * reach_error + 1.3f * v.half_error;
    return value > margin ? 1 : value < -margin ? -1 : 0;
  }
};

}  // namespace alphascope
