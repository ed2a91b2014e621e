// SPDX-License-Identifier: GPL-3.0-or-later
// Measures one tetrahedron outside the balls, and the offsets of its arcs and corners. Host and
// device.
#pragma once

#include <math.h>

#include <cstdint>

#include "core/complex/outside_part.hpp"
#include "core/measure/arc_tangent.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_tetrahedron.hpp"
#include "core/measure/ball_triple.hpp"

namespace alphascope {

// The faces that are in K_alpha, as bits. Balls go by their numbers, triangles by the opposite
// ball. Edges of a tetrahedron are 01, 02, 03, 12, 13, 23. Edges of a triangle are 12, 02, 01: by
// the opposite ball.
struct FacesIn {
  std::uint32_t balls = 0, edges = 0, triangles = 0;
};

// An angle with its sine.
struct AngleAndSine {
  double angle, sine;
};
ALPHASCOPE_INLINE AngleAndSine smaller(const AngleAndSine& a, const AngleAndSine& b) {
  return b.angle < a.angle ? b : a;
}
ALPHASCOPE_INLINE AngleAndSine larger(const AngleAndSine& a, const AngleAndSine& b) {
  return a.angle < b.angle ? b : a;
}
ALPHASCOPE_INLINE AngleAndSine opposite(const AngleAndSine& a) {
  return {-a.angle, -a.sine};
}

// The sector of a tube of radius s around an arc of radius r, between the directions to both
// centres; per radian of the arc. By Pappus' theorem, with r - t cos(theta) as the distance from
// the axis. Angles are from the direction to the axis.
struct TubeSector {
  double volume, area;
  double overlap;  // the part of `area` that lies across the axis; negative
};
struct TubeAngles {
  AngleAndSine low, high;
  AngleAndSine meets;  // where the tube meets the axis; 0 if it does not

  ALPHASCOPE_INLINE TubeAngles(const double (&radius)[2], const BallPair& pair, double r, double s)
      : low(opposite(towards(pair.height[0], radius[0], r))),
        high(towards(pair.height[1], radius[1], r)),
        meets{0, 0} {
    if (r >= s) return;
    const double reach = sqrt((s - r) * (s + r));
    meets = {arc_tangent(reach, r), reach / s};
  }

 private:
  static ALPHASCOPE_INLINE AngleAndSine towards(double height, double radius, double r) {
    // A ball of radius 0 has its centre on the arc.
    return {arc_tangent(height, r), radius > 0 ? height / radius : 0};
  }
};
ALPHASCOPE_INLINE double tube_area_between(const AngleAndSine& from, const AngleAndSine& to,
                                           double r, double s) {
  return s * (r * (to.angle - from.angle) - s * (to.sine - from.sine));
}
ALPHASCOPE_INLINE double tube_volume_between(const AngleAndSine& from, const AngleAndSine& to,
                                             double r, double s) {
  return s * s * (r * (to.angle - from.angle) / 2 - s * (to.sine - from.sine) / 3);
}
ALPHASCOPE_INLINE TubeSector tube_sector(const double (&radius)[2], const BallPair& pair,
                                         double s) {
  const double r = sqrt(pair.square_disc);
  const TubeAngles at(radius, pair, r, s);
  TubeSector sector{tube_volume_between(at.low, at.high, r, s),
                    tube_area_between(at.low, at.high, r, s), 0};
  if (r < s) {
    const AngleAndSine from = larger(at.low, opposite(at.meets)), to = smaller(at.high, at.meets);
    if (from.angle < to.angle) sector.overlap = tube_area_between(from, to, r, s);
  }
  return sector;
}

// The solid angle at the point where three spheres meet, between the directions to their centres.
ALPHASCOPE_INLINE double corner_angle(const GrownBall (&ball)[3], const BallPair (&pair)[3],
                                      double half_chord, double normal) {
  double product[3];  // for each edge the scalar product of the directions to its ends
  for (int m = 0; m < 3; ++m) {
    const GrownBall &a = ball[m == 0 ? 1 : 0], &b = ball[m == 2 ? 1 : 2];
    product[m] = 0.5 * (a.square_radius + b.square_radius - pair[m].distance * pair[m].distance);
  }
  double below = ball[0].grown_radius * ball[1].grown_radius * ball[2].grown_radius;
  for (int m = 0; m < 3; ++m) below += product[m] * ball[m].grown_radius;
  return 2 * arc_tangent(normal * half_chord, below);
}

// For callers that know that no ball is smaller than the solvent radius.
struct NoSmallBalls {
  static constexpr bool kThere = false;
};

// `SmallBalls` measures what offsets become at balls that are smaller than the solvent radius.
template <class SmallBalls>
class OutsideBody {
 public:
  ALPHASCOPE_INLINE OutsideBody(const GrownBall (&ball)[4], const FacesIn& in, double solvent)
      : ball_(ball), in_(in), solvent_(solvent), at_(ball_tetrahedron(ball)) {
    for (int e = 0; e < 6; ++e) angle_[e] = dihedral_at(at_, e);
    part_.whole = part_.volume = at_.at.six_volumes / 6;
  }

  ALPHASCOPE_INLINE OutsidePart part() {
    for (int n = 0; n < 4; ++n) {
      if (in_.balls >> n & 1) take_ball(n);
    }
    for (int e = 0; e < 6; ++e) {
      arc_[e] = angle_[e];
      if (in_.edges >> e & 1) take_edge(e);
    }
    for (int m = 0; m < 4; ++m) {
      if (in_.triangles >> m & 1) take_triangle(m);
    }
    for (int e = 0; e < 6; ++e) {
      if (in_.edges >> e & 1) add_arc(e);
    }
    return part_;
  }

 private:
  static ALPHASCOPE_INLINE int end_of(int e, int end) {
    constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    return kEnds[e][end];
  }

  ALPHASCOPE_INLINE void take_ball(int n) {
    // The solid angle is the sum of the dihedral angles of the three edges at the ball, minus pi.
    double angle = -kPi;
    for (int e = 0; e < 6; ++e) {
      if (end_of(e, 0) == n || end_of(e, 1) == n) angle += angle_[e];
    }
    const double area = angle * ball_[n].square_radius;
    part_.area[n] = area;
    part_.volume -= area * ball_[n].grown_radius / 3;
  }

  ALPHASCOPE_INLINE void take_edge(int e) {
    pair_[e] = ball_pair(ball_[end_of(e, 0)], ball_[end_of(e, 1)]);
    const double share = angle_[e] / (2 * kPi);
    for (int end = 0; end < 2; ++end) {
      const double radius = ball_[end_of(e, end)].grown_radius;
      const double cap = cap_height(pair_[e], end, radius);
      part_.area[end_of(e, end)] -= share * cap_area(radius, cap);
      part_.volume += share * cap_volume(radius, cap);
    }
  }

  ALPHASCOPE_INLINE void take_triangle(int m) {
    constexpr int kBallsOfFace[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
    // For each face the edge opposite each of its balls, in the order of kBallsOfFace.
    constexpr int kEdgesOfFace[4][3] = {{5, 4, 3}, {5, 2, 1}, {4, 2, 0}, {3, 1, 0}};
    const GrownBall ball[3] = {ball_[kBallsOfFace[m][0]], ball_[kBallsOfFace[m][1]],
                               ball_[kBallsOfFace[m][2]]};
    const BallPair pair[3] = {pair_[kEdgesOfFace[m][0]], pair_[kEdgesOfFace[m][1]],
                              pair_[kEdgesOfFace[m][2]]};
    const BallTriple triple = ball_triple(ball, pair);
    for (int n = 0; n < 3; ++n) {
      part_.area[kBallsOfFace[m][n]] += triple.area[n];
      part_.volume -= triple.volume[n];
      arc_[kEdgesOfFace[m][n]] -= triple.half_angle[n];
    }
    ++part_.corners;
    const auto& normal_of_face = at_.at.normal[m];
    const double normal = sqrt(dot(normal_of_face, normal_of_face));
    if constexpr (SmallBalls::kThere) {
      if (is_small(ball[0]) || is_small(ball[1]) || is_small(ball[2])) {
        SmallBalls::add_corner(pair, triple, normal, solvent_, part_);
        return;
      }
    }
    const double angle = corner_angle(ball, pair, triple.half_chord, normal);
    part_.offset_volume += angle * solvent_ * solvent_ * solvent_ / 3;
    part_.offset_area += angle * solvent_ * solvent_;
  }

  ALPHASCOPE_INLINE void add_arc(int e) {
    part_.arc += arc_[e] * sqrt(pair_[e].square_disc);
    const GrownBall &first = ball_[end_of(e, 0)], &second = ball_[end_of(e, 1)];
    const double radius[2] = {first.grown_radius, second.grown_radius};
    TubeSector sector;
    if constexpr (SmallBalls::kThere) {
      sector = is_small(first) || is_small(second)
                   ? SmallBalls::tube_sector_to_axis(radius, pair_[e], solvent_)
                   : tube_sector(radius, pair_[e], solvent_);
    } else {
      sector = tube_sector(radius, pair_[e], solvent_);
    }
    part_.offset_volume += arc_[e] * sector.volume;
    part_.offset_area += arc_[e] * sector.area;
    part_.offset_overlap += arc_[e] * sector.overlap;
  }

  ALPHASCOPE_INLINE bool is_small(const GrownBall& ball) const {
    return ball.grown_radius < solvent_;
  }

  const GrownBall (&ball_)[4];
  const FacesIn& in_;
  const double solvent_;
  const BallTetrahedron at_;
  double angle_[6], arc_[6];
  BallPair pair_[6];  // only for edges in K_alpha
  OutsidePart part_{};
};

}  // namespace alphascope
