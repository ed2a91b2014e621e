// The dual facet of an edge ij: the polygon P_ij = V_i ∩ V_j in the radical plane of balls i and j,
// cut by the bisectors of i with its other neighbours. One template body for filtered and exact
// arithmetic, for the CPU and the CUDA executor. What a finished polygon says about simplices is
// facet_complex.hpp's business.
//
// Legend (lattice units, origin p_i; lifted vectors (d, c) as in orthosphere.hpp):
//   plane     2 d_j·x = c_j, oriented and its axes renamed so that q = ±d_j has q.x = |d_j|_max > 0
//   line k    2 (a y + b z) <= c      where  (a, b, c) = q.x (d_k.y, d_k.z, c_k) - d_k.x (q.y, q.z,
//   e) side s    the part of a line that bounds the polygon; sides run counter-clockwise corner s
//   where side s meets side s+1:  (y, z) = (u, v) / (2 w),  w > 0
// Source: N. P. Ranjanikar's thesis for the locality; clipping facets instead of enumerating
// 4-tuples is ours (docs/algorithm.md).
#pragma once

#include "core/geometry/orthosphere.hpp"

namespace alphascope {

template <class T>
struct FacetLine {
  T a, b, c;
};

// The radical plane of i and j with its axes renamed; made once per facet.
template <class T>
struct FacetFrame {
  LiftedVector<T> q;  // (d_j, c_j) up to sign, permuted
  int axis;           // which coordinate became x

  ALPHASCOPE_INLINE FacetLine<T> line(const LiftedVector<T>& k) const {
    const LiftedVector<T> p = permuted(k, axis);
    return {p.y * q.x - p.x * q.y, p.z * q.x - p.x * q.z, p.c * q.x - q.c * p.x};
  }
  ALPHASCOPE_INLINE static LiftedVector<T> permuted(const LiftedVector<T>& k, int axis) {
    if (axis == 0) return k;
    if (axis == 1) return {k.y, k.z, k.x, k.c};
    return {k.z, k.x, k.y, k.c};
  }
};

template <class T>
ALPHASCOPE_INLINE FacetFrame<T> make_facet_frame(const LiftedVector<T>& j, int axis,
                                                 bool negative) {
  LiftedVector<T> q = FacetFrame<T>::permuted(j, axis);
  if (negative) q = {-q.x, -q.y, -q.z, -q.c};
  return {q, axis};
}

// The coordinate of d_j that is largest in absolute value, and whether it is negative.
struct FacetAxis {
  int axis;
  bool negative;
};
ALPHASCOPE_INLINE FacetAxis facet_axis(std::int64_t x, std::int64_t y, std::int64_t z) {
  const std::int64_t ax = x < 0 ? -x : x, ay = y < 0 ? -y : y, az = z < 0 ? -z : z;
  if (ax >= ay && ax >= az) return {0, x < 0};
  if (ay >= az) return {1, y < 0};
  return {2, z < 0};
}

// Sides with negative ids are ghosts: the start triangle y >= -g, z >= -g, y + z <= 2 g, which
// contains the disc { x : pi_i(x) <= alpha } of radius < g in its interior. Nothing on a ghost side
// or corner can be in K_alpha.
inline constexpr int kGhostY = -1, kGhostZ = -2, kGhostYZ = -3;

// The ghosts as lifted vectors (2 d·x <= c), with axes permuted back to those of the lattice.
ALPHASCOPE_INLINE LiftedInt ghost_vector(int id, int axis, std::int64_t g) {
  LiftedInt p = id == kGhostY   ? LiftedInt{0, -1, 0, 2 * g}
                : id == kGhostZ ? LiftedInt{0, 0, -1, 2 * g}
                                : LiftedInt{0, 1, 1, 4 * g};
  if (axis == 1) return {p.z, p.x, p.y, p.c};
  if (axis == 2) return {p.y, p.z, p.x, p.c};
  return p;
}

// What the templates below ask of a polygon (its storage is the executor's: growing arrays on the
// CPU, a few words of a thread on the GPU; its arithmetic is the precision's):
//   Line                       type of a line
//   size, capacity()           number of sides, and of sides that fit
//   id(s), line(s)             the ball of side s as its caller numbers it, or a ghost; its line
//   set_side(s, id, line)
//   meet(s, line, next_line)   sets corner s to where the two lines meet
//   move(from, to)             copies a side with the corner at its end
enum class ClipOutcome { unchanged, changed, empty, uncertain, full };

// Homogeneous coordinates of a corner: exact in integers, statically bounded in double.
template <class T>
struct FacetCorner {
  T u, v, w;

  ALPHASCOPE_INLINE void meet(const FacetLine<T>& k, const FacetLine<T>& l) {
    u = k.c * l.b - l.c * k.b;
    v = k.a * l.c - l.a * k.c;
    w = k.a * l.b - l.a * k.b;
  }
  // Positive where the line cuts the corner off.
  ALPHASCOPE_INLINE T beyond(const FacetLine<T>& m) const { return m.a * u + m.b * v - m.c * w; }
};

// Sets the start triangle from the lines of the ghosts.
template <class Polygon, class Line>
ALPHASCOPE_INLINE void start_polygon(Polygon& p, const Line& yz, const Line& y, const Line& z) {
  p.size = 3;
  p.set_side(0, kGhostYZ, yz);
  p.set_side(1, kGhostY, y);
  p.set_side(2, kGhostZ, z);
  p.meet(0, yz, y);
  p.meet(1, y, z);
  p.meet(2, z, yz);
}

// The same in the units of FacetFrame<T>::line, for a disc of radius < g.
template <class Polygon, class T>
ALPHASCOPE_INLINE void start_polygon(Polygon& p, const FacetFrame<T>& frame, std::int64_t g) {
  const T q = frame.q.x, reach = T(2 * g) * q;
  using Line = FacetLine<T>;
  start_polygon(p, Line{q, q, reach + reach}, Line{-q, T(0), reach}, Line{T(0), -q, reach});
}

// Cuts the polygon by a line. `side(s)` says whether the line cuts corner s off: +1 yes, -1 no, 0
// not known. With consistent signs the cut corners are one run of the cycle.
template <class Polygon, class SideOf>
ALPHASCOPE_INLINE ClipOutcome clip(Polygon& p, const typename Polygon::Line& m, int id,
                                   const SideOf& side) {
  const int n = p.size;
  int cut_count = 0, first = 0;  // first: the corner where the run of cut ones begins
  bool cut_zero = false, previous = false;
  for (int s = 0; s < n; ++s) {
    const int sign = side(s);
    if (sign == 0) return ClipOutcome::uncertain;
    const bool cut = sign > 0;
    cut_count += cut;
    if (s == 0)
      cut_zero = cut;
    else if (cut && !previous)
      first = s;
    previous = cut;
  }
  if (cut_count == 0) return ClipOutcome::unchanged;
  if (cut_count == n) return ClipOutcome::empty;
  if (cut_zero && !previous) first = 0;

  // Corners first..last and sides first+1..last go; side m and two corners come.
  const int grow = 2 - cut_count;
  if (n + grow > p.capacity()) return ClipOutcome::full;
  const int last = first + cut_count - 1;  // may pass n: the run wraps around
  const int after_index = last + 1 < n ? last + 1 : last + 1 - n;
  const typename Polygon::Line before = p.line(first), after = p.line(after_index);
  if (last < n - 1) {  // no wrap: move the tail (sides and corners from last+1 on)
    if (grow > 0) {
      for (int t = n - 1; t > last; --t) p.move(t, t + grow);
    } else if (grow < 0) {
      for (int t = last + 1; t < n; ++t) p.move(t, t + grow);
    }
    p.size = n + grow;
  } else {  // the run reaches or passes the end: keep after_index..first, moved to the front
    if (after_index > 0) {
      for (int t = after_index; t <= first; ++t) p.move(t, t - after_index);
      first -= after_index;
    }
    p.size = first + 2;
  }
  p.set_side(first + 1, id, m);
  p.meet(first, before, m);
  p.meet(first + 1, m, after);
  return ClipOutcome::changed;
}

// Bound on the rounding error of the predicate value in floating point of unit roundoff u, for
// lines of balls with |d_x| <= d and |c| <= c (both >= 1, c >= 4 g): |a|,|b| <= 2d², |line c| <=
// 2dc, the corner terms <= 8 d³c and 8 d⁴, the three products of the value <= 16 d⁵c each, with at
// most 12 roundings on any path: 12 u · 48 d⁵c = 576 u d⁵c, and a margin for the second order.
template <class T>
ALPHASCOPE_INLINE T clip_error_bound(T d, T c, T unit_roundoff) {
  return T(600) * unit_roundoff * (d * d) * (d * d) * (d * c);
}

// The clip predicate of one corner in double precision from integer vectors: does ball m cut off
// the corner of facet ij where k and l (balls or ghosts) meet? +1, -1, or 0 when the filter cannot
// tell.
ALPHASCOPE_HOST_DEVICE inline int corner_cut_filtered(const LiftedInt& j, const FacetAxis& axis,
                                                      const LiftedInt& k, const LiftedInt& l,
                                                      const LiftedInt& m) {
  const LiftedVector<double> v[4] = {lifted_as<double>(j), lifted_as<double>(k),
                                     lifted_as<double>(l), lifted_as<double>(m)};
  double d = 1, c = 1;
  for (const auto& a : v) {
    d = fmax(d, fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z))));
    c = fmax(c, fabs(a.c));
  }
  const auto frame = make_facet_frame(v[0], axis.axis, axis.negative);
  FacetCorner<double> corner;
  corner.meet(frame.line(v[1]), frame.line(v[2]));
  const double value = corner.beyond(frame.line(v[3]));
  const double bound = clip_error_bound(d, c, kUnitRoundoff);
  return (value > bound) - (value < -bound);
}

// The same in integers (Int128 or WideInt<4>, as clip_error_bound's products require): 0 is a tie.
template <class Integer>
ALPHASCOPE_HOST_DEVICE int corner_cut_exact(const LiftedInt& j, const FacetAxis& axis,
                                            const LiftedInt& k, const LiftedInt& l,
                                            const LiftedInt& m) {
  const auto frame = make_facet_frame(lifted_as<Integer>(j), axis.axis, axis.negative);
  FacetCorner<Integer> corner;
  corner.meet(frame.line(lifted_as<Integer>(k)), frame.line(lifted_as<Integer>(l)));
  return sign_of(corner.beyond(frame.line(lifted_as<Integer>(m))));
}

}  // namespace alphascope
