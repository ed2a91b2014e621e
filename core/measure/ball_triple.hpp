// SPDX-License-Identifier: GPL-3.0-or-later
// The intersection of three balls. Source: H. Edelsbrunner, P. Koehl, "The geometry of biomolecular
// solvation" (2005). Cap heights and spherical excess replace angles of corners, so that tangent
// balls lose no digits. Host and device.
#pragma once

#include <math.h>

#include "core/geometry/host_device.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/ortho_coordinates.hpp"

namespace alphascope {

// Three balls 0, 1 and 2 whose spheres meet in two points, or touch. The points are mirror images,
// so all numbers are for the half on one side of the centres' plane. Edge m is opposite ball m.
struct BallTriple {
  double half_chord;     // distance of a common point from the plane
  double reach[3];       // distance of the points' midpoint from edge m, positive towards ball m
  double half_angle[3];  // half angle of the circle of edge m inside ball m; 0 to pi
  // Area and volume of the part of sphere m and of ball m beyond both radical planes: half of
  // A_m;jk and of V_m;jk. The union of three balls subtracts them, as it would count them twice.
  double area[3];
  double volume[3];
};

// Half of A_m;jk. The pairs of numbers are for the other two balls. The part of the sphere beyond
// both planes is the two sectors of caps minus the triangle of their poles and the common point.
// For a plane with a negative height the opposite pole is used, so that a small circle stays small.
struct TripleCorner {
  double radius, height[2], half_angle[2], edge[2], product;  // product: edge[0] edge[1] cosine
};
ALPHASCOPE_INLINE double triple_corner_area(const TripleCorner& at, double chord_normal) {
  const double r = at.radius;
  const double s0 = at.height[0] < 0 ? -1 : 1, s1 = at.height[1] < 0 ? -1 : 1;
  const double h0 = fabs(at.height[0]), h1 = fabs(at.height[1]);
  const double c0 = h0 < r ? r - h0 : 0, c1 = h1 < r ? r - h1 : 0;
  const double e01 = at.edge[0] * at.edge[1];
  const double below = r * (e01 + s0 * s1 * at.product) + (h0 + h1) * e01;
  const double excess = 2 * arc_tangent(chord_normal, below);
  double area =
      r * (s0 * c0 * at.half_angle[0] + s1 * c1 * at.half_angle[1] - s0 * s1 * r * excess);
  if (s0 < 0 && s1 < 0) area += 2 * kPi * r * r;
  return area;
}

// `pair[m]` has the balls of edge m, the lower one first.
ALPHASCOPE_INLINE BallTriple ball_triple(const GrownBall (&ball)[3], const BallPair (&pair)[3]) {
  const LiftedInt b = lifted_vector(ball[0], ball[1]), c = lifted_vector(ball[0], ball[2]);
  const TriangleCoordinates at = triangle_coordinates(b, c);
  const std::int64_t bc = dot(b, c);
  const double product[3] = {static_cast<double>(bc), static_cast<double>(dot(b, b) - bc),
                             static_cast<double>(dot(c, c) - bc)};
  const double normal = sqrt(at.square_normal);
  BallTriple of;
  double square = 0, disc = 0;
  for (int m = 0; m < 3; ++m) {
    of.reach[m] = at.foot[m] * normal / pair[m].distance;
    if (m == 0 || pair[m].square_disc < disc) {
      disc = pair[m].square_disc;
      square = disc - of.reach[m] * of.reach[m];
    }
  }
  of.half_chord = square > 0 ? sqrt(square) : 0;
  for (int m = 0; m < 3; ++m) of.half_angle[m] = arc_tangent(of.half_chord, of.reach[m]);
  const double chord_normal = of.half_chord * normal;
  for (int m = 0; m < 3; ++m) {
    const int j = m == 0 ? 1 : 0, k = m == 2 ? 1 : 2;  // the others; edge k joins m and j
    const double hj = pair[k].height[m < j ? 0 : 1], hk = pair[j].height[m < k ? 0 : 1];
    const TripleCorner corner = {ball[m].grown_radius,
                                 {hj, hk},
                                 {of.half_angle[k], of.half_angle[j]},
                                 {pair[k].distance, pair[j].distance},
                                 product[m]};
    of.area[m] = triple_corner_area(corner, chord_normal);
    const double segment_j = pair[k].square_disc * of.half_angle[k] - of.reach[k] * of.half_chord;
    const double segment_k = pair[j].square_disc * of.half_angle[j] - of.reach[j] * of.half_chord;
    of.volume[m] =
        (ball[m].grown_radius * of.area[m] - 0.5 * (hj * segment_j + hk * segment_k)) / 3;
  }
  return of;
}

}  // namespace alphascope
