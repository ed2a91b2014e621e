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

// The same sector, cut off at the axis. Nothing lies beyond the centre of a ball that is smaller
// than the solvent radius. The sector consists of parts of two tubes, and of triangles with the
// axis between them.
TubeSector tube_sector_to_axis(const double (&radius)[2], const BallPair& pair, double solvent) {
  const double r = std::sqrt(pair.square_disc), s = solvent;
  const TubeAngles at(radius, pair, r, s);
  TubeSector sector{0, 0, 0};
  const auto add = [&](const AngleAndSine& from, const AngleAndSine& to) {
    if (from.angle >= to.angle) return;
    sector.volume += tube_volume_between(from, to, r, s);
    sector.area += tube_area_between(from, to, r, s);
  };
  add(at.low, smaller(at.high, opposite(at.meets)));
  add(larger(at.low, at.meets), at.high);
  if (r < s) {
    const double reach = std::sqrt((s - r) * (s + r));  // along the axis
    const double along = std::min(pair.height[1], reach) - std::max(-pair.height[0], -reach);
    if (along > 0) sector.volume += pair.square_disc * along / 6;
  }
  return sector;
}

// The part of a ball of the solvent radius around the point where three spheres meet, in the
// tetrahedron of that point and the three centres.
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

struct MeasuredSmallBalls {
  static constexpr bool kThere = true;
  static TubeSector tube_sector_to_axis(const double (&radius)[2], const BallPair& pair,
                                        double solvent) {
    return alphascope::tube_sector_to_axis(radius, pair, solvent);
  }
  static void add_corner(const BallPair (&pair)[3], const BallTriple& triple, double normal,
                         double solvent, OutsidePart& to) {
    const SharedMeasures corner = corner_to_plane(pair, triple, normal, solvent);
    to.offset_volume += corner.volume;
    to.offset_area += corner.area;
  }
};

}  // namespace

OutsidePart outside_part(const GrownBall (&ball)[4], const FacesIn& in, double solvent) {
  return OutsideBody<MeasuredSmallBalls>(ball, in, solvent).part();
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
    const double angle = arc_tangent(twice_area, product[n]);
    part.area -= angle / 2 * ball[n].square_radius;
    part.length += angle * ball[n].grown_radius;
  }
  for (int m = 0; m < 3; ++m) {  // The half of each lens of two discs.
    if (!(in.edges >> m & 1)) continue;
    const GrownBall ends[2] = {ball[m == 0 ? 1 : 0], ball[m == 2 ? 1 : 2]};
    const BallPair pair = ball_pair(ends[0], ends[1]);
    const double disc = std::sqrt(pair.square_disc);
    for (int end = 0; end < 2; ++end) {
      const double angle = arc_tangent(disc, pair.height[end]);
      part.area += (angle * ends[end].square_radius - pair.height[end] * disc) / 2;
      part.length -= angle * ends[end].grown_radius;
    }
  }
  return part;
}

}  // namespace alphascope
