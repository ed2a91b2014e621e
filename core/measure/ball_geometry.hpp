// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms for one, two and three balls, and the angles of tetrahedra. All lengths are in one
// unit. Differences of lattice points are exact as doubles. No formula divides by the radius of a
// circle in which two spheres meet, so tangent balls lose no digits. Host and device.
//
// The radical plane of balls i and j is where their powers are equal. h_ij is the distance of
// centre i from it, positive towards j. If the spheres meet, |h_ij| <= R_i.
#pragma once

#include <math.h>

#include <cstdint>

#include "core/geometry/host_device.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/arc_tangent.hpp"
#include "core/predicates/lifted.hpp"

namespace alphascope {

inline constexpr double kPi = 3.14159265358979323846;

// A ball grown by alpha. Centre and radius are in lattice units, so that differences are exact.
struct GrownBall {
  std::int32_t x, y, z;
  std::int32_t radius;   // before growing
  double square_radius;  // R² = radius² + alpha; 0 where that is negative
  double grown_radius;   // R
};
ALPHASCOPE_INLINE GrownBall grown_ball(const LatticePoint& p, std::int32_t radius,
                                       const LatticeAlpha& alpha_on_lattice) {
  const double square = alpha_on_lattice.plus(std::int64_t{radius} * radius);
  const double positive = square > 0 ? square : 0;
  return {p.x, p.y, p.z, radius, positive, sqrt(positive)};
}
// The lifted vector of ball k, seen from ball i: p_k - p_i, and |p_k - p_i|² + R_i² - R_k². Both
// are exact.
ALPHASCOPE_INLINE LiftedInt lifted_vector(const GrownBall& i, const GrownBall& k) {
  return lifted_vector(i, i.radius, k, k.radius);
}

ALPHASCOPE_INLINE double sphere_area(double radius) {
  return 4 * kPi * radius * radius;
}
ALPHASCOPE_INLINE double ball_volume(double radius) {
  return 4 * kPi / 3 * radius * radius * radius;
}
// Area and volume of the part of a ball beyond a plane; the height is between 0 and two radii.
ALPHASCOPE_INLINE double cap_area(double radius, double height) {
  return 2 * kPi * radius * height;
}
ALPHASCOPE_INLINE double cap_volume(double radius, double height) {
  return kPi / 3 * height * height * (3 * radius - height);
}

// The solid angle of the cone of three vectors, 0 to 2 pi. A. Van Oosterom, J. Strackee, IEEE
// Trans. Biomed. Eng. 30 (1983) 125.
template <class V>
ALPHASCOPE_INLINE double solid_angle(const V& a, const V& b, const V& c) {
  const double la = sqrt(dot(a, a)), lb = sqrt(dot(b, b)), lc = sqrt(dot(c, c));
  const double below = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
  return 2 * arc_tangent(fabs(dot(a, cross(b, c))), below);
}

// The angle at edge `u` between the half-planes towards a and b, 0 to pi.
template <class V>
ALPHASCOPE_INLINE double dihedral_angle(const V& u, const V& a, const V& b) {
  const auto ua = cross(u, a), ub = cross(u, b);
  return arc_tangent(sqrt(dot(u, u)) * fabs(dot(a, ub)), dot(ua, ub));
}

// Two balls i and j whose spheres meet: the distances of their centres from the radical plane, and
// the disc that both spheres have in it.
struct BallPair {
  double distance;     // distance of the centres
  double height[2];    // h_ij, h_ji
  double square_disc;  // squared radius of the disc
};
ALPHASCOPE_INLINE BallPair ball_pair(const GrownBall& i, const GrownBall& j) {
  const LiftedInt v = lifted_vector(i, j);
  const std::int64_t square = v.x * v.x + v.y * v.y + v.z * v.z;
  BallPair pair;
  pair.distance = sqrt(static_cast<double>(square));
  const double half = 0.5 / pair.distance;
  pair.height[0] = static_cast<double>(v.c) * half;
  pair.height[1] = static_cast<double>(square - (v.c - square)) * half;
  // The smaller ball gives the smaller error.
  const int small = i.square_radius <= j.square_radius ? 0 : 1;
  const double radius = small == 0 ? i.grown_radius : j.grown_radius;
  const double below = radius - fabs(pair.height[small]);
  pair.square_disc = below > 0 ? below * (radius + fabs(pair.height[small])) : 0;
  return pair;
}
// The radius of the circle in which both spheres meet, by Heron's formula. At alpha 0, tangent
// balls have radii and a distance that are whole numbers, so the result is exactly 0. For nearly
// tangent balls half of the digits are right, because the radius is a root of their overlap.
ALPHASCOPE_INLINE double circle_radius(const GrownBall& i, const GrownBall& j,
                                       const BallPair& pair) {
  const double d = pair.distance, sum = i.grown_radius + j.grown_radius;
  const double difference = i.grown_radius - j.grown_radius;
  const double square = (sum - d) * (sum + d) * ((d - difference) * (d + difference));
  return square > 0 ? sqrt(square) / (2 * d) : 0;
}
// The height of the cap of ball `end` beyond the radical plane.
ALPHASCOPE_INLINE double cap_height(const BallPair& pair, int end, double radius) {
  const double height = radius - pair.height[end];
  return height < 0 ? 0 : height > 2 * radius ? 2 * radius : height;
}

}  // namespace alphascope
