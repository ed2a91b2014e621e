// SPDX-License-Identifier: GPL-3.0-or-later
// Distances and angles from exact dot and cross products. Coordinates are below 2^29 units, so
// differences have 30 bits, their cross and dot products 62, and a triple product 93.
#include "core/measure/angles.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/geometry/lattice_point.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {
namespace {

using Vector = std::array<std::int64_t, 3>;
static_assert(kMaxLatticeCoordinate < (1 << 29));

Vector from_to(const LatticePoint& a, const LatticePoint& b) {
  return {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y, std::int64_t{b.z} - a.z};
}
std::int64_t dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Vector& a) {
  return a == Vector{};
}

// The entries of cross products are too large for exact squares, so this is in doubles.
double real_dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += static_cast<double>(a[k]) * static_cast<double>(b[k]);
  return sum;
}
double length(const Vector& a) {
  return std::sqrt(real_dot(a, a));
}
double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

}  // namespace

double distance_on_lattice(const LatticePoint& a, const LatticePoint& b) {
  const Vector v = from_to(a, b);
  return std::sqrt(static_cast<double>(dot(v, v)));
}

// The arctangent is equally exact near 0 and 180 degrees; the arccosine is not.
std::optional<double> angle_degrees(const LatticePoint& a, const LatticePoint& b,
                                    const LatticePoint& c) {
  const Vector u = from_to(b, a), v = from_to(b, c);
  if (is_zero(u) || is_zero(v)) return std::nullopt;
  return degrees(std::atan2(length(cross(u, v)), static_cast<double>(dot(u, v))));
}

// The angle between the normals of both planes, from sine and cosine times the same lengths. The
// triple product has the sign of the sine exactly.
std::optional<double> dihedral_degrees(const LatticePoint& a, const LatticePoint& b,
                                       const LatticePoint& c, const LatticePoint& d) {
  const Vector first = from_to(a, b), axis = from_to(b, c), last = from_to(c, d);
  const Vector before = cross(first, axis), after = cross(axis, last);
  if (is_zero(before) || is_zero(after)) return std::nullopt;
  Int128 triple = 0;
  for (int k = 0; k < 3; ++k) triple += static_cast<Int128>(first[k]) * after[k];
  const double sine = length(axis) * static_cast<double>(triple);
  const double turn = degrees(std::atan2(sine, real_dot(before, after)));
  return turn == -180 ? 180 : turn;  // -180 is a tiny negative sine, rounded
}

}  // namespace alphascope
