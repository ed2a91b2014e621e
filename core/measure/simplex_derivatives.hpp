// SPDX-License-Identifier: GPL-3.0-or-later
// The terms that each simplex adds to the derivatives of the union's area and volume, by the
// centres and grown radii of its balls. When a sphere moves, the arcs C_ij in which it meets others
// move (R. Bryant, H. Edelsbrunner, P. Koehl, M. Levitt, "The area derivative of a space-filling
// diagram", 2004; H. Edelsbrunner, P. Koehl, "The weighted-volume derivative of a space-filling
// diagram", 2003):
//   dV/dR_i = A_i,  dV/dp_i = - sum of D_ij u_ij,
//   dA/dR_i = 2 A_i / R_i - sum of L_ij (d² - (R_i - R_j)²) / 2d,
//   dA/dp_i = sum of - L_ij u_ij (R_i + R_j) (d² - (R_i - R_j)²) / 2d² + (R_i - R_j) / d W_ij
// where u_ij is the unit vector from i to j, D the area of the wall between them, L the angle of
// the arcs, and W the integral over that angle of the vector from the arcs' centre. A sink has
// area_slope(i, x), area_gradient(i, vector) and volume_gradient(i, vector). They get all terms
// except 2 A / R and A. Host and device.
#pragma once

#include "core/geometry/ball_set.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_tetrahedron.hpp"
#include "core/measure/ball_triple.hpp"

namespace alphascope {

ALPHASCOPE_INLINE Vector3<double> scaled(const Vector3<double>& v, double by) {
  return {v.x * by, v.y * by, v.z * by};
}
ALPHASCOPE_INLINE Vector3<double> between(const GrownBall& from, const GrownBall& to) {
  return {static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y),
          static_cast<double>(to.z - from.z)};
}
// Adds a vector to one ball and the opposite vector to the other.
template <class Sink>
ALPHASCOPE_INLINE void add_opposite_area_gradients(const BallIndex (&i)[2],
                                                   const Vector3<double>& v, Sink& sink) {
  sink.area_gradient(i[0], v);
  sink.area_gradient(i[1], scaled(v, -1));
}
template <class Sink>
ALPHASCOPE_INLINE void add_opposite_volume_gradients(const BallIndex (&i)[2],
                                                     const Vector3<double>& v, Sink& sink) {
  sink.volume_gradient(i[0], v);
  sink.volume_gradient(i[1], scaled(v, -1));
}

// The derivatives per unit of angle and of wall.
struct PairMotion {
  Vector3<double> unit;         // u_ij
  double arc_slope, arc_force;  // factors of L: in dA/dR, and along u_ij in dA/dp
  double arc_turn;              // factor of W
};
ALPHASCOPE_INLINE PairMotion pair_motion(const GrownBall& i, const GrownBall& j,
                                         const BallPair& pair) {
  const double d = pair.distance, difference = i.grown_radius - j.grown_radius;
  const double slope = (d - difference) * (d + difference) / (2 * d);
  return {scaled(between(i, j), 1 / d), -slope, -slope * (i.grown_radius + j.grown_radius) / d,
          difference / d};
}
template <class Sink>
ALPHASCOPE_INLINE void add_arc_and_wall(const BallIndex (&i)[2], const PairMotion& motion,
                                        double angle, double wall, Sink& sink) {
  sink.area_slope(i[0], motion.arc_slope * angle);
  sink.area_slope(i[1], motion.arc_slope * angle);
  add_opposite_area_gradients(i, scaled(motion.unit, motion.arc_force * angle), sink);
  add_opposite_volume_gradients(i, scaled(motion.unit, -wall), sink);
}

// A triangle with open sides cuts the arcs of its three edges, and cuts segments off their walls.
template <class Sink>
ALPHASCOPE_INLINE void triangle_derivatives(const BallIndex (&i)[3], const GrownBall (&ball)[3],
                                            const BallPair (&pair)[3], const BallTriple& triple,
                                            int open_sides, Sink& sink) {
  for (int m = 0; m < 3; ++m) {
    const int a = m == 0 ? 1 : 0, b = m == 2 ? 1 : 2;
    const BallIndex ends[2] = {i[a], i[b]};
    const PairMotion motion = pair_motion(ball[a], ball[b], pair[m]);
    const double segment =
        pair[m].square_disc * triple.half_angle[m] - triple.reach[m] * triple.half_chord;
    add_arc_and_wall(ends, motion, -open_sides * triple.half_angle[m], -0.5 * open_sides * segment,
                     sink);
    // The direction to ball m at a right angle to the edge.
    const Vector3<double> to = between(ball[a], ball[m]);
    const double along = dot(to, motion.unit);
    const Vector3<double> across = {to.x - along * motion.unit.x, to.y - along * motion.unit.y,
                                    to.z - along * motion.unit.z};
    const double length = sqrt(dot(across, across));
    const double turn = length > 0 ? motion.arc_turn * open_sides * triple.half_chord / length : 0;
    add_opposite_area_gradients(ends, scaled(across, -turn), sink);
  }
}

// A tetrahedron adds to the walls of its edges; its open faces add to W.
template <class Sink>
ALPHASCOPE_INLINE void tetrahedron_derivatives(const BallIndex (&i)[4], const GrownBall (&ball)[4],
                                               const BallTetrahedron& t, std::uint32_t open_faces,
                                               Sink& sink) {
  constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  // The faces at edge e are opposite the balls kEnds[5 - e]. kPlace is the index in each of these
  // faces of the other ball.
  constexpr int kPlace[6][2] = {{2, 2}, {2, 1}, {1, 1}, {2, 0}, {1, 0}, {0, 0}};
  for (int e = 0; e < 6; ++e) {
    const int a = kEnds[e][0], b = kEnds[e][1], m = kEnds[5 - e][0], n = kEnds[5 - e][1];
    const BallIndex ends[2] = {i[a], i[b]};
    const double foot_n = t.foot[m][kPlace[e][0]], foot_m = t.foot[n][kPlace[e][1]];
    const double d2 = t.square_edge[e];
    // wall = six_volumes / 2d (..), along a vector of length d.
    const double wall =
        t.at.six_volumes / (2 * d2) * (foot_n * t.at.centre[m] + foot_m * t.at.centre[n]);
    add_opposite_volume_gradients(ends, scaled(between(ball[a], ball[b]), -wall), sink);
    const double turn = (ball[a].grown_radius - ball[b].grown_radius) / d2 * t.at.outward;
    if (open_faces >> m & 1)
      add_opposite_area_gradients(ends, scaled(t.at.normal[m], turn * foot_n), sink);
    if (open_faces >> n & 1)
      add_opposite_area_gradients(ends, scaled(t.at.normal[n], turn * foot_m), sink);
  }
}

}  // namespace alphascope
