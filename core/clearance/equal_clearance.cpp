// SPDX-License-Identifier: GPL-3.0-or-later
// Solves for the place of equal clearance: in closed form between three balls, by bisection between
// two in a plane.
#include "core/clearance/equal_clearance.hpp"

#include <cmath>

#include "core/geometry/alpha.hpp"

namespace alphascope {

// Let x be measured from the first centre. Then |x|² = (r + s)² and |x - d|² = (r' + s)². Their
// difference is linear in x and s. Two such equations give x = p + s q in the plane. The first
// equation is then quadratic in s.
EqualClearance equal_clearance(const BallSet& balls, const std::array<BallIndex, 3>& three) {
  const double unit = balls.lattice.unit_angstrom();
  const auto centre = [&](std::size_t n) { return unit * real_point(balls.centres[three[n]]); };
  const auto radius = [&](std::size_t n) { return unit * balls.radii[three[n]]; };
  const RealPoint d = centre(1) - centre(0), e = centre(2) - centre(0);
  const double r = radius(0);
  const double dd = dot(d, d), de = dot(d, e), ee = dot(e, e);
  const double determinant = dd * ee - de * de;
  if (!(determinant > 1e-12 * dd * ee)) return {};
  // d·x = a + a' s and e·x = b + b' s.
  const double a = (dd - (radius(1) - r) * (radius(1) + r)) / 2, a_s = r - radius(1);
  const double b = (ee - (radius(2) - r) * (radius(2) + r)) / 2, b_s = r - radius(2);
  const auto in_plane = [&](double along_d, double along_e) {
    return (1 / determinant) *
           ((ee * along_d - de * along_e) * d + (dd * along_e - de * along_d) * e);
  };
  const RealPoint p = in_plane(a, b), q = in_plane(a_s, b_s);
  const double square = dot(q, q) - 1, half = dot(p, q) - r, rest = dot(p, p) - r * r;
  const double root = std::sqrt(half * half - square * rest);
  if (!std::isfinite(root)) return {};
  // Computes both roots without a difference of nearly equal numbers. For equal radii q is 0 and
  // one root is far away.
  const double sum = half > 0 ? -half - root : -half + root;
  EqualClearance best;
  for (const double s : {rest / sum, sum / square}) {
    const bool outside = std::isfinite(s) && r + s >= 0 && radius(1) + s >= 0 && radius(2) + s >= 0;
    if (!outside || (best.found && s >= best.clearance_angstrom)) continue;
    best = {true, centre(0) + p + s * q, s};
  }
  return best;
}

// On the segment between the feet of both centres one distance rises and the other falls. Bisection
// finds where they are equal.
EqualClearance equal_clearance_in_plane(const BallSet& balls, const std::array<BallIndex, 2>& two,
                                        const Plane& plane) {
  std::array<RealPoint, 2> foot;
  std::array<double, 2> height;
  for (std::size_t n = 0; n < 2; ++n) {
    const RealPoint centre = real_point(balls.centres[two[n]]);
    height[n] = dot(centre - plane.point, plane.normal);
    foot[n] = centre - height[n] * plane.normal;
  }
  const RealPoint along = foot[1] - foot[0];
  const auto distance = [&](std::size_t n, double share) {
    const double in_plane = (n == 0 ? share : 1 - share) * length(along);
    return std::hypot(in_plane, height[n]) - balls.radii[two[n]];
  };
  const auto difference = [&](double share) { return distance(0, share) - distance(1, share); };
  if (!(difference(0) < 0 && difference(1) > 0)) return {};
  double low = 0, high = 1;
  constexpr int kHalvings = 60;
  for (int n = 0; n < kHalvings; ++n) {
    const double middle = (low + high) / 2;
    (difference(middle) < 0 ? low : high) = middle;
  }
  const double unit = balls.lattice.unit_angstrom();
  return {true, unit * (foot[0] + low * along), unit * distance(0, low)};
}

}  // namespace alphascope
