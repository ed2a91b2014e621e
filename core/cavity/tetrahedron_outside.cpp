// SPDX-License-Identifier: GPL-3.0-or-later
// Measures one tetrahedron outside the balls and the offsets of its arcs and corners, and one
// triangle of a mouth.
#include "core/cavity/tetrahedron_outside.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/convex_piece.hpp"

namespace alphascope {
namespace {

constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
constexpr int kBallsOfFace[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
// For each face the edge opposite each of its balls, in the order of kBallsOfFace.
constexpr int kEdgesOfFace[4][3] = {{5, 4, 3}, {5, 2, 1}, {4, 2, 0}, {3, 1, 0}};

// The sector of a tube of radius `solvent` around an arc, between the directions to both centres;
// per radian of the arc. By Pappus' theorem, with r - t cos(theta) as the distance from the axis.
struct TubeSector {
  double volume, area;
  double overlap;  // the part of `area` that lies across the axis; negative
};

double area_between(double from, double to, double r, double s) {
  return s * (r * (to - from) - s * (std::sin(to) - std::sin(from)));
}
double volume_between(double from, double to, double r, double s) {
  return s * s * (r * (to - from) / 2 - s * (std::sin(to) - std::sin(from)) / 3);
}

TubeSector tube_sector(const GrownBall (&ball)[2], const BallPair& pair, double solvent) {
  const double r = std::sqrt(pair.square_disc), s = solvent;
  // Angles from the direction to the axis.
  const double low = -std::atan2(pair.height[0], r), high = std::atan2(pair.height[1], r);
  const auto sine = [&](int end) {  // a ball of radius 0 has its centre on the arc
    const double radius = ball[end].grown_radius;
    return radius > 0 ? pair.height[end] / radius : 0;
  };
  TubeSector sector;
  sector.volume = s * s * (r * (high - low) / 2 - s * (sine(0) + sine(1)) / 3);
  sector.area = area_between(low, high, r, s);
  sector.overlap = 0;
  if (r < s) {
    const double meets = std::acos(r / s);
    const double from = std::max(low, -meets), to = std::min(high, meets);
    if (from < to) sector.overlap = area_between(from, to, r, s);
  }
  return sector;
}

// The same sector, cut off at the axis. Nothing lies beyond the centre of a ball that is smaller
// than the solvent radius. The sector consists of parts of two tubes, and of triangles with the
// axis between them.
TubeSector tube_sector_to_axis(const BallPair& pair, double solvent) {
  const double r = std::sqrt(pair.square_disc), s = solvent;
  const double low = -std::atan2(pair.height[0], r), high = std::atan2(pair.height[1], r);
  const double meets = r < s ? std::acos(r / s) : 0;
  TubeSector sector{0, 0, 0};
  const auto add = [&](double from, double to) {
    if (from >= to) return;
    sector.volume += volume_between(from, to, r, s);
    sector.area += area_between(from, to, r, s);
  };
  add(low, std::min(high, -meets));
  add(std::max(low, meets), high);
  if (r < s) {
    const double reach = std::sqrt((s - r) * (s + r));  // along the axis
    const double along = std::min(pair.height[1], reach) - std::max(-pair.height[0], -reach);
    if (along > 0) sector.volume += pair.square_disc * along / 6;
  }
  return sector;
}

// The solid angle at the point where three spheres meet, between the directions to their centres.
double corner_angle(const GrownBall (&ball)[3], const BallPair (&pair)[3], double half_chord,
                    double normal) {
  double product[3];  // for each edge the scalar product of the directions to its ends
  for (int m = 0; m < 3; ++m) {
    const GrownBall &a = ball[m == 0 ? 1 : 0], &b = ball[m == 2 ? 1 : 2];
    product[m] = 0.5 * (a.square_radius + b.square_radius - pair[m].distance * pair[m].distance);
  }
  double below = ball[0].grown_radius * ball[1].grown_radius * ball[2].grown_radius;
  for (int m = 0; m < 3; ++m) below += product[m] * ball[m].grown_radius;
  return 2 * std::atan2(normal * half_chord, below);
}

// The part of a ball of the solvent radius around that point, in the tetrahedron of point and three
// centres.
SharedMeasures corner_to_plane(const BallPair (&pair)[3], const BallTriple& triple, double normal,
                               double solvent) {
  // Centre 0 is the origin of the plane, and centre 1 is on its x axis. Then all is shifted to the
  // point's view. The point lies over the foot of the radical axis in the plane.
  const double base = pair[2].distance;
  const double along = pair[1].distance * pair[1].distance - pair[0].distance * pair[0].distance;
  const Vector3<double> at[3] = {
      {0, 0, 0}, {base, 0, 0}, {(along + base * base) / (2 * base), normal / base, 0}};
  Vector3<double> corner[4] = {{0, 0, 0}, {}, {}, {}};
  for (int n = 0; n < 3; ++n) {
    corner[n + 1] = {at[n].x - pair[2].height[0], at[n].y - triple.reach[2], triple.half_chord};
  }
  const PieceFace side{{0, 0, 0}, 0, 0};  // a face through the point
  ConvexPiece piece;
  piece.start(corner, {{{0, 0, 1}, triple.half_chord, 0}, side, side, side}, false);
  return piece.shared_with_ball(solvent);
}

class Outside {
 public:
  Outside(const GrownBall (&ball)[4], const FacesIn& in, double solvent)
      : ball_(ball), in_(in), solvent_(solvent), at_(ball_tetrahedron(ball)) {
    for (int e = 0; e < 6; ++e) angle_[e] = dihedral_at(at_, e);
    part_.whole = part_.volume = at_.at.six_volumes / 6;
  }

  OutsidePart part() {
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
  void take_ball(int n) {
    // The solid angle is the sum of the dihedral angles of the three edges at the ball, minus pi.
    double angle = -kPi;
    for (int e = 0; e < 6; ++e) {
      if (kEnds[e][0] == n || kEnds[e][1] == n) angle += angle_[e];
    }
    part_.area[n] = angle * ball_[n].square_radius;
    part_.volume -= part_.area[n] * ball_[n].grown_radius / 3;
  }

  void take_edge(int e) {
    const auto [a, b] = kEnds[e];
    pair_[e] = ball_pair(ball_[a], ball_[b]);
    const double share = angle_[e] / (2 * kPi);
    for (int end = 0; end < 2; ++end) {
      const double radius = ball_[kEnds[e][end]].grown_radius;
      const double cap = cap_height(pair_[e], end, radius);
      part_.area[static_cast<std::size_t>(kEnds[e][end])] -= share * cap_area(radius, cap);
      part_.volume += share * cap_volume(radius, cap);
    }
  }

  void take_triangle(int m) {
    const int(&balls)[3] = kBallsOfFace[m];
    const int(&edges)[3] = kEdgesOfFace[m];
    const GrownBall ball[3] = {ball_[balls[0]], ball_[balls[1]], ball_[balls[2]]};
    const BallPair pair[3] = {pair_[edges[0]], pair_[edges[1]], pair_[edges[2]]};
    const BallTriple triple = ball_triple(ball, pair);
    for (int n = 0; n < 3; ++n) {
      part_.area[static_cast<std::size_t>(balls[n])] += triple.area[n];
      part_.volume -= triple.volume[n];
      arc_[edges[n]] -= triple.half_angle[n];
    }
    ++part_.corners;
    const auto& normal_of_face = at_.at.normal[m];
    const double normal = std::sqrt(dot(normal_of_face, normal_of_face));
    if (is_small(ball[0]) || is_small(ball[1]) || is_small(ball[2])) {
      const SharedMeasures corner = corner_to_plane(pair, triple, normal, solvent_);
      part_.offset_volume += corner.volume;
      part_.offset_area += corner.area;
      return;
    }
    const double angle = corner_angle(ball, pair, triple.half_chord, normal);
    part_.offset_volume += angle * solvent_ * solvent_ * solvent_ / 3;
    part_.offset_area += angle * solvent_ * solvent_;
  }

  void add_arc(int e) {
    part_.arc += arc_[e] * std::sqrt(pair_[e].square_disc);
    const GrownBall ball[2] = {ball_[kEnds[e][0]], ball_[kEnds[e][1]]};
    const TubeSector sector = is_small(ball[0]) || is_small(ball[1])
                                  ? tube_sector_to_axis(pair_[e], solvent_)
                                  : tube_sector(ball, pair_[e], solvent_);
    part_.offset_volume += arc_[e] * sector.volume;
    part_.offset_area += arc_[e] * sector.area;
    part_.offset_overlap += arc_[e] * sector.overlap;
  }

  bool is_small(const GrownBall& ball) const { return ball.grown_radius < solvent_; }

  const GrownBall (&ball_)[4];
  const FacesIn& in_;
  const double solvent_;
  const BallTetrahedron at_;
  double angle_[6], arc_[6];
  BallPair pair_[6];  // only for edges in K_alpha
  OutsidePart part_{};
};

}  // namespace

OutsidePart outside_part(const GrownBall (&ball)[4], const FacesIn& in, double solvent) {
  return Outside(ball, in, solvent).part();
}

MouthPart mouth_part(const GrownBall (&ball)[3], const FacesIn& in) {
  const LiftedInt v01 = lifted_vector(ball[0], ball[1]), v02 = lifted_vector(ball[0], ball[2]),
                  v12 = lifted_vector(ball[1], ball[2]);
  const auto normal = as_doubles(cross(v01, v02));
  const double twice_area = std::sqrt(dot(normal, normal));
  const double product[3] = {static_cast<double>(dot(v01, v02)),
                             -static_cast<double>(dot(v01, v12)),
                             static_cast<double>(dot(v02, v12))};
  MouthPart part{twice_area / 2, 0};
  for (int n = 0; n < 3; ++n) {
    if (!(in.balls >> n & 1)) continue;
    const double angle = std::atan2(twice_area, product[n]);
    part.area -= angle / 2 * ball[n].square_radius;
    part.length += angle * ball[n].grown_radius;
  }
  for (int m = 0; m < 3; ++m) {  // The half of each lens of two discs.
    if (!(in.edges >> m & 1)) continue;
    const GrownBall ends[2] = {ball[m == 0 ? 1 : 0], ball[m == 2 ? 1 : 2]};
    const BallPair pair = ball_pair(ends[0], ends[1]);
    const double disc = std::sqrt(pair.square_disc);
    for (int end = 0; end < 2; ++end) {
      const double angle = std::atan2(disc, pair.height[end]);
      part.area += (angle * ends[end].square_radius - pair.height[end] * disc) / 2;
      part.length -= angle * ends[end].grown_radius;
    }
  }
  return part;
}

}  // namespace alphascope
