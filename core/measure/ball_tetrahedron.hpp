// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a tetrahedron of balls that belongs to each ball: where its power is the least of the
// four. It consists of six orthoschemes for each ball. Their corners are the ball's centre and the
// orthocentres of an edge, a triangle and the tetrahedron. The volume of an orthoscheme is a
// product of barycentric coordinates, with its sign. Host and device.
#pragma once

#include <math.h>

#include "core/geometry/host_device.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/ortho_coordinates.hpp"

namespace alphascope {

// Edges are numbered 01, 02, 03, 12, 13, 23: edge e is opposite edge 5 - e.
struct BallTetrahedron {
  TetrahedronCoordinates at;
  // foot[m]: barycentric coordinates of the orthocentre of the face opposite ball m. The balls of
  // the face are numbered in ascending order.
  double foot[4][3];
  double square_edge[6];
  // Position of the radical plane on the edge: 0 at the first ball, 1 at the other.
  double radical[6];
};
ALPHASCOPE_INLINE BallTetrahedron ball_tetrahedron(const GrownBall (&ball)[4]) {
  const LiftedInt v01 = lifted_vector(ball[0], ball[1]), v02 = lifted_vector(ball[0], ball[2]);
  const LiftedInt v03 = lifted_vector(ball[0], ball[3]), v12 = lifted_vector(ball[1], ball[2]);
  const LiftedInt v13 = lifted_vector(ball[1], ball[3]), v23 = lifted_vector(ball[2], ball[3]);
  BallTetrahedron t;
  t.at = tetrahedron_coordinates(v01, v02, v03);
  const auto face = [&](int m, const LiftedInt& b, const LiftedInt& c) {
    const auto of = triangle_coordinates(b, c, dot(t.at.normal[m], t.at.normal[m]));
    for (int n = 0; n < 3; ++n) t.foot[m][n] = of.foot[n];
  };
  face(0, v12, v13);
  face(1, v02, v03);
  face(2, v01, v03);
  face(3, v01, v02);
  const auto edge = [&](int e, const LiftedInt& v) {
    t.square_edge[e] = static_cast<double>(dot(v, v));
    t.radical[e] = 0.5 * static_cast<double>(v.c) / t.square_edge[e];
  };
  edge(0, v01);
  edge(1, v02);
  edge(2, v03);
  edge(3, v12);
  edge(4, v13);
  edge(5, v23);
  return t;
}

// Volumes of the four parts; their sum is that of the tetrahedron.
ALPHASCOPE_INLINE void orthoscheme_shares(const BallTetrahedron& t, double (&share)[4]) {
  constexpr int kEdge[4][3] = {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}};  // 01, 02, 12 of a face
  constexpr int kBall[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  for (double& s : share) s = 0;
  for (int m = 0; m < 4; ++m) {
    const double weight = t.at.six_volumes / 6 * t.at.centre[m];
    const double* foot = t.foot[m];
    const double r01 = t.radical[kEdge[m][0]], r02 = t.radical[kEdge[m][1]],
                 r12 = t.radical[kEdge[m][2]];
    share[kBall[m][0]] += weight * (r01 * foot[2] + r02 * foot[1]);
    share[kBall[m][1]] += weight * ((1 - r01) * foot[2] + r12 * foot[0]);
    share[kBall[m][2]] += weight * ((1 - r02) * foot[1] + (1 - r12) * foot[0]);
  }
}

// The angle of the tetrahedron between its faces at edge e, 0 to pi.
ALPHASCOPE_INLINE double dihedral_at(const BallTetrahedron& t, int e) {
  constexpr int kFaces[6][2] = {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}};
  const auto& m = t.at.normal[kFaces[e][0]];
  const auto& n = t.at.normal[kFaces[e][1]];
  return arc_tangent(sqrt(t.square_edge[e]) * t.at.six_volumes, -dot(m, n));
}

}  // namespace alphascope
