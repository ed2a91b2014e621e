// SPDX-License-Identifier: GPL-3.0-or-later
// Lifted vectors and orthocentres of any size in GMP's integers, for comparison with predicates.
#pragma once

#include "core/geometry/ball_set.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope::testing {

using Integer = mpz_class;

// Like core/predicates/lifted.hpp.
struct BigVector {
  Integer x, y, z, c;
};

inline BigVector big_vector(const BallSet& balls, BallIndex i, BallIndex k) {
  const LatticePoint &p = balls.centres[i], &q = balls.centres[k];
  BigVector v{Integer(q.x) - p.x, Integer(q.y) - p.y, Integer(q.z) - p.z, 0};
  v.c = v.x * v.x + v.y * v.y + v.z * v.z + Integer(balls.radii[i]) * balls.radii[i] -
        Integer(balls.radii[k]) * balls.radii[k];
  return v;
}
inline BigVector cross_of(const BigVector& a, const BigVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x, 0};
}
inline Integer dot_of(const BigVector& a, const BigVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
// a·f + b·g, coordinate by coordinate.
inline BigVector sum_of(const BigVector& a, const Integer& f, const BigVector& b,
                        const Integer& g) {
  return {a.x * f + b.x * g, a.y * f + b.y * g, a.z * f + b.z * g, 0};
}

// The orthocentre of some balls, within the flat through their centres: 2 x = centre / scale, with
// scale > 0. Scale 0: there is none.
struct BigCentre {
  BigVector centre;
  Integer scale;

  explicit BigCentre(const BigVector& j) : centre(sum_of(j, j.c, j, 0)), scale(dot_of(j, j)) {}
  BigCentre(const BigVector& j, const BigVector& k) {
    const BigVector n = cross_of(j, k);
    centre = cross_of(sum_of(k, j.c, j, -k.c), n);
    scale = dot_of(n, n);
  }
  BigCentre(const BigVector& j, const BigVector& k, const BigVector& l) {
    const BigVector kl = cross_of(k, l);
    centre = sum_of(sum_of(kl, j.c, cross_of(l, j), k.c), 1, cross_of(j, k), l.c);
    scale = dot_of(j, kl);
    if (sgn(scale) >= 0) return;
    centre = sum_of(centre, -1, centre, 0);
    scale = -scale;
  }
  // Sign of 2 d_m·x - c_m.
  int cut_by(const BigVector& m) const { return sgn(dot_of(m, centre) - m.c * scale); }
  // |x|² - w.
  Rational rho(const Integer& weight) const {
    Rational value(dot_of(centre, centre), 4 * scale * scale);
    value.canonicalize();
    return value - weight;
  }
};

}  // namespace alphascope::testing
