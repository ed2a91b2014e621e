// Facet polygons in single precision, every corner with its own certified error: the arithmetic of
// the GPU's hot path (laptop GPUs have almost no double precision). Same templates as
// facet_polygon.hpp; host and device, so that it is tested without a GPU.
//
// Lengths are lattice units times 2^-s, s chosen so that neighbours lie within 1: differences of up
// to 2^24 units stay exact. Legend, for plane 2 d_j·x = c_j with q = ±d_j as in facet_polygon.hpp:
//   plane    x = h - m1 y - m2 z,   m = q.yz / q.x,  h = c / (2 q.x)
//   line k   a y + b z <= t,        a = d.y - d.x m1,  b = d.z - d.x m2,  t = c / 2 - d.x h
//   corner   (y, z), each within e of the exact corner
// u = 2^-24. Every bound is computed in float as well: kU is 3 % above u to cover its roundings.
// Explicit fma is not contraction: it is the same on every machine.
#pragma once

#include "core/complex/facet_complex.hpp"

namespace alphascope {

inline constexpr float kU = 6.14e-8f;

struct FloatLine {
  float a, b, t;
  float slope_error;   // of a and of b
  float offset_error;  // of t
};

struct FloatFrame {
  float m1, m2, h;
  int axis;

  // `v` is exact but for c, which is the nearest float.
  ALPHASCOPE_INLINE FloatLine line(const LiftedVector<float>& v) const {
    const LiftedVector<float> p = FacetFrame<float>::permuted(v, axis);
    FloatLine l;
    l.a = fmaf(-p.x, m1, p.y);
    l.b = fmaf(-p.x, m2, p.z);
    const float half = 0.5f * p.c, shift = p.x * h;
    l.t = half - shift;
    // m errs by u (it is at most 1), h by 2u relative.
    l.slope_error = kU * (fabsf(p.x) + fmaxf(fabsf(l.a), fabsf(l.b)));
    l.offset_error = kU * (fabsf(half) + 3.1f * fabsf(shift) + fabsf(l.t));
    return l;
  }
};

ALPHASCOPE_INLINE FloatFrame make_float_frame(const LiftedVector<float>& j, const FacetAxis& axis) {
  // A sign common to q and c_j cancels in all three.
  const LiftedVector<float> q = FacetFrame<float>::permuted(j, axis.axis);
  return {q.y / q.x, q.z / q.x, 0.5f * q.c / q.x, axis.axis};
}

// g is a power of two in lattice units, so the ghosts are the same in every precision.
ALPHASCOPE_INLINE FloatLine ghost_line(int id, float g) {
  if (id == kGhostY) return {-1.0f, 0.0f, g, 0.0f, 0.0f};
  if (id == kGhostZ) return {0.0f, -1.0f, g, 0.0f, 0.0f};
  return {1.0f, 1.0f, 2.0f * g, 0.0f, 0.0f};
}

struct FloatCorner {
  float y, z, e;

  ALPHASCOPE_INLINE void meet(const FloatLine& k, const FloatLine& l) {
    const float det = k.a * l.b - l.a * k.b;
    const float sk = fmaxf(fabsf(k.a), fabsf(k.b)) + k.slope_error;
    const float sl = fmaxf(fabsf(l.a), fabsf(l.b)) + l.slope_error;
    const float det_error = 2.0f * (sl * k.slope_error + sk * l.slope_error) + 4.0f * kU * sk * sl;
    const float inverse = 1.0f / det;  // det > 0 in exact arithmetic
    y = (k.t * l.b - l.t * k.b) * inverse;
    z = (k.a * l.t - l.a * k.t) * inverse;
    const float numerator_error = sl * (k.offset_error + 2.0f * kU * fabsf(k.t)) +
                                  sk * (l.offset_error + 2.0f * kU * fabsf(l.t)) +
                                  fabsf(k.t) * l.slope_error + fabsf(l.t) * k.slope_error;
    const float size = fmaxf(fabsf(y), fabsf(z));
    // The quotient's two roundings are in the last term; a det that may vanish makes e infinite.
    e = det > 2.0f * det_error
            ? (numerator_error + size * det_error) / (det - det_error) * 1.02f + 2.1f * kU * size
            : HUGE_VALF;
  }
};

// A box around all corners and their errors.
struct FloatBox {
  float y0, y1, z0, z1;
  float size;  // largest absolute coordinate

  ALPHASCOPE_INLINE void clear() {
    y0 = z0 = HUGE_VALF;
    y1 = z1 = -HUGE_VALF;
  }
  ALPHASCOPE_INLINE void add(const FloatCorner& c) {
    y0 = fminf(y0, c.y - 1.01f * c.e);
    y1 = fmaxf(y1, c.y + 1.01f * c.e);
    z0 = fminf(z0, c.z - 1.01f * c.e);
    z1 = fmaxf(z1, c.z + 1.01f * c.e);
  }
  ALPHASCOPE_INLINE void finish() { size = fmaxf(fmaxf(-y0, y1), fmaxf(-z0, z1)); }
};

// Everything about a line that the side test of a corner needs, made once per line.
struct FloatSideTest {
  FloatLine line;
  float by_error, by_size, constant;

  ALPHASCOPE_INLINE explicit FloatSideTest(const FloatLine& l) : line(l) {
    const float s = fmaxf(fabsf(l.a), fabsf(l.b)) + l.slope_error;
    by_error = 2.05f * s;
    by_size = 2.05f * l.slope_error + 6.0f * kU * s;
    constant = 1.02f * l.offset_error + 2.0f * kU * fabsf(l.t);
  }
  // True when no point of the box is cut off: the line can be skipped without looking at corners.
  ALPHASCOPE_INLINE bool spares(const FloatBox& box) const {
    const float reach =
        fmaf(line.a, line.a > 0 ? box.y1 : box.y0, line.b * (line.b > 0 ? box.z1 : box.z0));
    return reach + fmaf(by_size, box.size, constant) < line.t;
  }
  // +1 cut off, -1 kept, 0 not known (also when a corner is not a number).
  ALPHASCOPE_INLINE int side(const FloatCorner& c) const {
    const float value = fmaf(line.a, c.y, fmaf(line.b, c.z, -line.t));
    const float error = fmaf(by_error, c.e, fmaf(by_size, fmaxf(fabsf(c.y), fabsf(c.z)), constant));
    return value > error ? 1 : value < -error ? -1 : 0;
  }
};

// A polygon in the local memory of a thread. Lines are recomputed when a cut needs them.
template <class Neighbours, int kCapacity>
struct FloatPolygon {
  using Line = FloatLine;
  const FloatFrame& frame;
  const Neighbours& neighbours;  // .scaled(slot) -> LiftedVector<float>
  float ghost_reach;
  int size = 0;
  FloatCorner corners[kCapacity];
  short ids[kCapacity];

  ALPHASCOPE_INLINE FloatPolygon(const FloatFrame& f, const Neighbours& n, float g)
      : frame(f), neighbours(n), ghost_reach(g) {}
  ALPHASCOPE_INLINE int capacity() const { return kCapacity; }
  ALPHASCOPE_INLINE int id(int s) const { return ids[s]; }
  ALPHASCOPE_INLINE FloatLine line(int s) const {
    return ids[s] < 0 ? ghost_line(ids[s], ghost_reach) : frame.line(neighbours.scaled(ids[s]));
  }
  ALPHASCOPE_INLINE void set_side(int s, int id, const FloatLine&) {
    ids[s] = static_cast<short>(id);
  }
  ALPHASCOPE_INLINE void meet(int s, const FloatLine& k, const FloatLine& l) {
    corners[s].meet(k, l);
  }
  ALPHASCOPE_INLINE void move(int from, int to) {
    ids[to] = ids[from];
    corners[to] = corners[from];
  }
};

}  // namespace alphascope
