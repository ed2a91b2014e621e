// SPDX-License-Identifier: GPL-3.0-or-later
// The terms that each simplex of an alpha complex adds to the area and volume of its balls. They
// are those of angle-weighted inclusion-exclusion (H. Edelsbrunner, "The union of balls and its
// dual shape", 1995), summed over the simplices with an open side. A simplex that is filled on all
// sides adds no angle. Its class decides that, not a sum of angles that should cancel. Host and
// device.
//
// A_i = R_i² pi (4 - 2 edges + tetrahedra) + sum over edges of R_i h_ij X_ij + sum over triangles
// of their corners on open sides, where X is the angle at an edge that no tetrahedron fills.
// 3 V_i = R_i A_i + sum over j of h_ij D_ij, where D is the area of the wall between i and j.
// The arcs of edge ij on the surface, in which spheres i and j meet, have the length r_ij L_ij,
// where r is the radius of their circle and L the angle of the circle outside all other balls:
// L_ij = 2 pi - dihedral angles of its tetrahedra - half angles of its triangles' open sides.
// A tetrahedron covers its dihedral angle of the circle. Beyond an open side of a triangle, half of
// the arc inside the third ball is covered. These are the terms of the area's derivative, too
// (simplex_derivatives.hpp). Pairs that are no open edge have no arc. Each ball gets half.
//
// A sink has ball(i) and add(quantity, i, x). The volume gets V_i - R_i A_i / 3. If kDerivatives
// holds, it also has the three functions of simplex_derivatives.hpp.
#pragma once

#include "core/complex/face_class.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_tetrahedron.hpp"
#include "core/measure/ball_triple.hpp"
#include "core/measure/measured_quantity.hpp"
#include "core/measure/simplex_derivatives.hpp"

namespace alphascope {

ALPHASCOPE_INLINE bool is_open(SimplexClass c) {
  return c != SimplexClass::interior;
}
// The number of open sides of a triangle; its class is the number of its tetrahedra.
ALPHASCOPE_INLINE int open_sides(SimplexClass triangle) {
  return 2 - static_cast<int>(triangle);
}

template <class Sink>
ALPHASCOPE_INLINE void vertex_terms(BallIndex i, Sink& sink) {
  sink.add(MeasuredQuantity::area, i, 4 * kPi * sink.ball(i).square_radius);
}

// `end_is_open[n]`: ball n of the edge is not interior.
template <class Sink>
ALPHASCOPE_INLINE void edge_terms(const BallIndex (&i)[2], const bool (&end_is_open)[2],
                                  bool is_open, Sink& sink) {
  const GrownBall ball[2] = {sink.ball(i[0]), sink.ball(i[1])};
  for (int n = 0; n < 2; ++n) {
    if (end_is_open[n]) sink.add(MeasuredQuantity::area, i[n], -2 * kPi * ball[n].square_radius);
  }
  if (!is_open) return;
  const BallPair pair = ball_pair(ball[0], ball[1]);
  for (int n = 0; n < 2; ++n) {
    sink.add(MeasuredQuantity::area, i[n], 2 * kPi * ball[n].grown_radius * pair.height[n]);
    sink.add(MeasuredQuantity::volume, i[n], kPi / 3 * pair.height[n] * pair.square_disc);
    sink.add(MeasuredQuantity::arc_length, i[n], kPi * circle_radius(ball[0], ball[1], pair));
  }
  if constexpr (Sink::kDerivatives) {
    const PairMotion motion = pair_motion(ball[0], ball[1], pair);
    add_arc_and_wall(i, motion, 2 * kPi, kPi * pair.square_disc, sink);
  }
}

// For a triangle with one or two open sides.
template <class Sink>
ALPHASCOPE_INLINE void triangle_terms(const BallIndex (&i)[3], int open_sides, Sink& sink) {
  const GrownBall ball[3] = {sink.ball(i[0]), sink.ball(i[1]), sink.ball(i[2])};
  const BallPair pair[3] = {ball_pair(ball[1], ball[2]), ball_pair(ball[0], ball[2]),
                            ball_pair(ball[0], ball[1])};
  const BallTriple triple = ball_triple(ball, pair);
  double arc[3];  // half of what the triangle covers on one side, by the edge opposite each ball
  for (int m = 0; m < 3; ++m) {
    arc[m] = 0.5 * triple.half_angle[m] *
             circle_radius(ball[m == 0 ? 1 : 0], ball[m == 2 ? 1 : 2], pair[m]);
  }
  for (int m = 0; m < 3; ++m) {
    sink.add(MeasuredQuantity::area, i[m], open_sides * triple.area[m]);
    sink.add(MeasuredQuantity::volume, i[m],
             open_sides * (triple.volume[m] - ball[m].grown_radius * triple.area[m] / 3));
    sink.add(MeasuredQuantity::arc_length, i[m],
             -open_sides * (arc[m == 0 ? 1 : 0] + arc[m == 2 ? 1 : 2]));
  }
  if constexpr (Sink::kDerivatives) {
    triangle_derivatives(i, ball, pair, triple, open_sides, sink);
  }
}

// The open parts of a tetrahedron, as bits: balls and edges that are not interior (by their
// numbers), and faces without a tetrahedron behind them (by the opposite ball).
struct OpenFaces {
  std::uint32_t balls, edges, faces;
};
// Sets all but the faces. is_edge_open(i, j) is called for open balls only.
template <class IsBallOpen, class IsEdgeOpen>
ALPHASCOPE_INLINE OpenFaces open_balls_and_edges(const BallIndex (&i)[4],
                                                 const IsBallOpen& is_ball_open,
                                                 const IsEdgeOpen& is_edge_open) {
  OpenFaces open = {0, 0, 0};
  for (int n = 0; n < 4; ++n) open.balls |= (is_ball_open(i[n]) ? 1u : 0u) << n;
  for (int e = 0, a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b, ++e) {
      if (!(open.balls >> a & open.balls >> b & 1)) continue;
      open.edges |= (is_edge_open(i[a], i[b]) ? 1u : 0u) << e;
    }
  }
  return open;
}

template <class Sink>
ALPHASCOPE_INLINE void tetrahedron_terms(const BallIndex (&i)[4], const OpenFaces& open,
                                         Sink& sink) {
  constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  const GrownBall ball[4] = {sink.ball(i[0]), sink.ball(i[1]), sink.ball(i[2]), sink.ball(i[3])};
  const BallTetrahedron t = ball_tetrahedron(ball);
  double volume[4];
  orthoscheme_shares(t, volume);
  double area[4] = {}, arc[4] = {};
  for (int n = 0; n < 4; ++n) {
    if (open.balls >> n & 1) area[n] = kPi * ball[n].square_radius;
  }
  for (int e = 0; e < 6; ++e) {
    if (!(open.edges >> e & 1)) continue;
    const int a = kEnds[e][0], b = kEnds[e][1];
    const double angle = dihedral_at(t, e);
    const BallPair pair = ball_pair(ball[a], ball[b]);
    area[a] -= ball[a].grown_radius * pair.height[0] * angle;
    area[b] -= ball[b].grown_radius * pair.height[1] * angle;
    const double covered = 0.5 * angle * circle_radius(ball[a], ball[b], pair);
    arc[a] -= covered;
    arc[b] -= covered;
    volume[a] -= pair.height[0] * pair.square_disc * angle / 6;
    volume[b] -= pair.height[1] * pair.square_disc * angle / 6;
    if constexpr (Sink::kDerivatives) {
      const PairMotion motion = pair_motion(ball[a], ball[b], pair);
      const BallIndex ends[2] = {i[a], i[b]};
      add_arc_and_wall(ends, motion, -angle, -0.5 * pair.square_disc * angle, sink);
    }
  }
  for (int n = 0; n < 4; ++n) {
    if (open.balls >> n & 1) {
      sink.add(MeasuredQuantity::area, i[n], area[n]);
      sink.add(MeasuredQuantity::arc_length, i[n], arc[n]);
    }
    sink.add(MeasuredQuantity::volume, i[n], volume[n]);
  }
  if constexpr (Sink::kDerivatives) tetrahedron_derivatives(i, ball, t, open.faces, sink);
}

}  // namespace alphascope
