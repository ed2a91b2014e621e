// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ball first touches the growing sphere at an open face of a tetrahedron. Host and device.
//
// The orthospheres of face ijk have their centres on its line of equal power, x(s) = foot + s n
// (core/dual_edge/power_line.hpp). Behind the face lies a known tetrahedron. The centre moves away
// from it, towards `side` times n. A ball m in front of the face, side (d_m·n) > 0, touches the
// sphere at
//   t = side s = (c_m / 2 - d_m·foot) / (side d_m·n).
// The ball with the least t makes the tetrahedron before the face. Without one the face is on the
// hull. A ball behind the face never touches: the sphere of the known tetrahedron is empty, and the
// part behind the face only shrinks.
#pragma once

#include "core/dual_edge/exact_dual_edge.hpp"
#include "core/dual_edge/power_line.hpp"

namespace alphascope {

// Bounds of t. The ball is certainly not in front if none() holds. `high` is infinite if the ball
// is perhaps not in front.
template <class Real>
struct Crossing {
  Real low, high;
  ALPHASCOPE_INLINE bool none() const { return !(low < kNever); }
  static constexpr Real kNever = Real(1e37);  // above every t
};

// A ball relative to ball i. The coordinates may be rounded once each. `size` is |d|² + |w_i - w_m|
// and c errs by at most 7 u of it.
template <class Real>
struct RoughLifted {
  LiftedVector<Real> v;
  Real size;
};
template <class Real>
ALPHASCOPE_INLINE RoughLifted<Real> rough_lifted(Real x, Real y, Real z, Real weights) {
  const Real square = multiply_add(x, x, multiply_add(y, y, z * z));
  return {{x, y, z, square + weights}, square + magnitude(weights)};
}

template <class Real>
class OpenFace {
 public:
  using Line = PowerLine<Real, sizeof(Real) == sizeof(double)>;

  // Prepares the face. False when the centres are collinear as far as can be told. The coordinates
  // of j and k must be exact, and c rounded to the nearest number.
  ALPHASCOPE_INLINE bool set(const LiftedVector<Real>& j, const LiftedVector<Real>& k, int side) {
    side_ = side;
    return line_.set(j, k);
  }

  ALPHASCOPE_INLINE Crossing<Real> crossing(const RoughLifted<Real>& m) const {
    constexpr Real u = Rounding<Real>::u;
    const auto cut = line_.line_cut(m.v);
    const Real length = magnitude(m.v.x) + magnitude(m.v.y) + magnitude(m.v.z);
    // Beyond cut_by(): one rounding of each coordinate, and an error of c of 7 u `size`.
    const Real slope_error =
        length * (line_.slope_error() + Real(1.1) * u * largest_coordinate(line_.direction()));
    const Real offset_error = multiply_add(
        Real(7) * u, m.size,
        length * (line_.offset_error() + Real(1.1) * u * largest_coordinate(line_.foot())));
    const Real slope = side_ > 0 ? cut.slope : -cut.slope;
    Crossing<Real> result{Crossing<Real>::kNever, Crossing<Real>::kNever};
    if (!(slope > -slope_error)) return result;
    if (slope > 8 * slope_error) {
      const Real inverse = rough_reciprocal(slope);
      const Real t = cut.offset * inverse, size = magnitude(t);
      // As in DualEdge::clip().
      const Real error = multiply_add(
          6 * u, size, Real(1.15) * inverse * multiply_add(size, slope_error, offset_error));
      result.low = t - error;
      result.high = t + error;
      return result;
    }
    const Real least = cut.offset - offset_error;
    result.low = least > 0 ? Real(0.99) * least / (slope + slope_error) : -Crossing<Real>::kNever;
    return result;
  }

  // The same face, seen by a sphere that moves the other way.
  ALPHASCOPE_INLINE OpenFace turned() const {
    OpenFace other = *this;
    other.side_ = -side_;
    return other;
  }

  ALPHASCOPE_INLINE const Line& line() const { return line_; }
  ALPHASCOPE_INLINE int side() const { return side_; }

 private:
  Line line_;
  int side_;
};

// Does ball m touch before ball l? Both are in front. All are lifted from ball i. Of two equal
// balls at the same centre neither does.
ALPHASCOPE_DEVICE_CALL bool touches_before(const LiftedInt& j, const LiftedInt& k,
                                           const LiftedInt& l, const LiftedInt& m) {
  if (l.x == m.x && l.y == m.y && l.z == m.z) return m.c < l.c;
  return orthocentre_cut<WideInt<4>>(j, k, {0, l}, m) > 0;
}

}  // namespace alphascope
