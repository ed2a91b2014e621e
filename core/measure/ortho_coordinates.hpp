// SPDX-License-Identifier: GPL-3.0-or-later
// Barycentric coordinates of orthocentres, the points of equal power, of two, three and four balls.
// All lengths, areas and volumes without an angle follow from these pure numbers. Numerators that
// would cancel in flat simplices are computed exactly, with the widths of lattice.hpp: vectors
// 2^30, their lifts 2^62, cross products 2^61. Host and device.
#pragma once

#include <math.h>

#include <cstdint>

#include "core/geometry/host_device.hpp"
#include "core/predicates/lifted.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {

using VectorInt = Vector3<std::int64_t>;
ALPHASCOPE_INLINE Vector3<double> as_doubles(const VectorInt& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// a b - c d, rounded once.
ALPHASCOPE_DEVICE_CALL double exact_difference(std::int64_t a, std::int64_t b, std::int64_t c,
                                               std::int64_t d) {
  return static_cast<double>(static_cast<Int128>(a) * b - static_cast<Int128>(c) * d);
}
// a x + b y + c z, rounded once.
ALPHASCOPE_DEVICE_CALL double exact_sum(std::int64_t a, std::int64_t x, std::int64_t b,
                                        std::int64_t y, std::int64_t c, std::int64_t z) {
  return static_cast<double>(static_cast<Int128>(a) * x + static_cast<Int128>(b) * y +
                             static_cast<Int128>(c) * z);
}

// A triangle or tetrahedron is flat below these limits: on the squared sine at ball 0, and on the
// squared volume relative to the edges at ball 0.
inline constexpr double kFlatTriangle = 1.0 / 4096;
inline constexpr double kFlatTetrahedron = 1.0 / 1048576;

// Coordinates of the triangle of ball 0 and the balls at b and c.
struct TriangleCoordinates {
  double foot[3];        // barycentric coordinates of the orthocentre
  double square_normal;  // |b x c|²
};
ALPHASCOPE_INLINE TriangleCoordinates triangle_coordinates(const LiftedInt& b, const LiftedInt& c,
                                                           double square_normal) {
  const std::int64_t bb = dot(b, b), cc = dot(c, c), bc = dot(b, c);
  const auto squares = static_cast<double>(bb) * static_cast<double>(cc);
  double at_b, at_c;  // twice the numerators
  if (square_normal > kFlatTriangle * squares) {
    const auto lift_b = static_cast<double>(b.c), lift_c = static_cast<double>(c.c);
    const auto product = static_cast<double>(bc);
    at_b = lift_b * static_cast<double>(cc) - lift_c * product;
    at_c = lift_c * static_cast<double>(bb) - lift_b * product;
  } else {
    at_b = exact_difference(b.c, cc, c.c, bc);
    at_c = exact_difference(c.c, bb, b.c, bc);
  }
  const double scale = 0.5 / square_normal;
  TriangleCoordinates of;
  of.foot[1] = at_b * scale;
  of.foot[2] = at_c * scale;
  of.foot[0] = 1 - of.foot[1] - of.foot[2];
  of.square_normal = square_normal;
  return of;
}
ALPHASCOPE_INLINE TriangleCoordinates triangle_coordinates(const LiftedInt& b, const LiftedInt& c) {
  const auto normal = as_doubles(cross(b, c));
  return triangle_coordinates(b, c, dot(normal, normal));
}

// Coordinates of the tetrahedron of ball 0 and the balls at b, c and d.
struct TetrahedronCoordinates {
  double centre[4];    // barycentric coordinates of the orthocentre
  double six_volumes;  // >= 0
  double outward;      // 1 if the normals point out, -1 if in
  // Of the face opposite each ball, with twice its area as length; all inwards or all outwards.
  Vector3<double> normal[4];
};
ALPHASCOPE_INLINE TetrahedronCoordinates tetrahedron_coordinates(const LiftedInt& b,
                                                                 const LiftedInt& c,
                                                                 const LiftedInt& d) {
  const VectorInt n1 = cross(c, d), n2 = cross(d, b), n3 = cross(b, c);
  const VectorInt n0 = {-n1.x - n2.x - n3.x, -n1.y - n2.y - n3.y, -n1.z - n2.z - n3.z};
  TetrahedronCoordinates of;
  of.normal[0] = as_doubles(n0);
  of.normal[1] = as_doubles(n1);
  of.normal[2] = as_doubles(n2);
  of.normal[3] = as_doubles(n3);
  const double x = static_cast<double>(d.x), y = static_cast<double>(d.y),
               z = static_cast<double>(d.z);
  double volume = x * of.normal[3].x + y * of.normal[3].y + z * of.normal[3].z;
  const double edges = static_cast<double>(dot(b, b)) * static_cast<double>(dot(c, c)) *
                       static_cast<double>(dot(d, d));
  Vector3<double> point;  // the orthocentre times twice `volume`, from ball 0
  if (volume * volume > kFlatTetrahedron * edges) {
    const auto lb = static_cast<double>(b.c), lc = static_cast<double>(c.c),
               ld = static_cast<double>(d.c);
    point.x = lb * of.normal[1].x + lc * of.normal[2].x + ld * of.normal[3].x;
    point.y = lb * of.normal[1].y + lc * of.normal[2].y + ld * of.normal[3].y;
    point.z = lb * of.normal[1].z + lc * of.normal[2].z + ld * of.normal[3].z;
  } else {
    volume = exact_sum(d.x, n3.x, d.y, n3.y, d.z, n3.z);
    point.x = exact_sum(b.c, n1.x, c.c, n2.x, d.c, n3.x);
    point.y = exact_sum(b.c, n1.y, c.c, n2.y, d.c, n3.y);
    point.z = exact_sum(b.c, n1.z, c.c, n2.z, d.c, n3.z);
  }
  const double scale = 0.5 / (volume * volume);
  of.centre[1] = dot(point, of.normal[1]) * scale;
  of.centre[2] = dot(point, of.normal[2]) * scale;
  of.centre[3] = dot(point, of.normal[3]) * scale;
  of.centre[0] = 1 - of.centre[1] - of.centre[2] - of.centre[3];
  of.six_volumes = fabs(volume);
  of.outward = volume < 0 ? 1 : -1;
  return of;
}

}  // namespace alphascope
