// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a triangulation to which balls are added, and the signs that decide it: tetrahedra,
// and cells at infinity. A cell at infinity joins a facet of the hull with a point at infinity. The
// balls of a cell are oriented: det(b1 - b0, b2 - b0, b3 - b0) > 0, and a point at infinity lies
// outside its facet.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/predicates/orthocentre_cut.hpp"
#include "core/predicates/rounding.hpp"

namespace alphascope {

// A ball in lattice units, all exact. Its weight is in square units.
struct InsertedBall {
  double x, y, z, weight;
};

struct alignas(64) Cell {
  static constexpr std::uint32_t kInfinity = ~std::uint32_t{0};
  enum State : std::uint32_t { kUsed, kInCavity, kFree };

  // Twice the orthocentre, seen from ball 0. Of a cell at infinity the normal of its facet, which
  // points outwards.
  double x, y, z;
  float error;  // see certify_cell()
  State state;
  // In the order of insertion. A point at infinity is the last one.
  std::uint32_t ball[4];
  // Across the face opposite each ball: four times the cell there, plus its corner there.
  std::uint32_t across[4];

  bool at_infinity() const { return ball[3] == kInfinity; }
};
static_assert(sizeof(Cell) == 64);

// A ball seen from another one. Coordinates are exact. c is rounded, and errs by at most 4.1 u
// `size`, which is |d|² + |w_i - w_m|.
struct SeenBall {
  double x, y, z, c, size;
};
inline SeenBall seen_from(const InsertedBall& i, const InsertedBall& m) {
  const double x = m.x - i.x, y = m.y - i.y, z = m.z - i.z, weights = i.weight - m.weight;
  const double square = x * x + y * y + z * z;
  return {x, y, z, square + weights, square + std::fabs(weights)};
}

// A ball of a new cell, with its largest coordinate.
struct CornerBall : SeenBall {
  CornerBall() = default;
  explicit CornerBall(const SeenBall& seen)
      : SeenBall(seen), largest(std::max({std::fabs(x), std::fabs(y), std::fabs(z)})) {}
  double largest;
};

// Sets the numbers of a tetrahedron of ball 0 and of j, k, l as ball 0 sees them. A ball m is in
// conflict with it where 2 d_m·x - c_m > 0. The computed value errs by at most
//   error · (|d_mx| + |d_my| + |d_mz|) + 6 u size_m.
//
// With L the largest coordinate and S the largest size of j, k and l: a coordinate of d_k × d_l is
// at most 2 L² and errs by 4 u L². Its product with c_j is at most 2 S L² and errs by 14.3 u S L².
// The sum of three errs by 56 u S L². The determinant errs by 32 u L³.
inline void certify_cell(const CornerBall& j, const CornerBall& k, const CornerBall& l,
                         Cell& cell) {
  constexpr double u = kUnitRoundoff;
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const double determinant = dot(j, kl);
  const double length = std::max({j.largest, k.largest, l.largest});
  const double size = std::max({j.size, k.size, l.size});
  const double square = length * length;
  if (!(determinant > 64 * u * square * length)) {
    cell.x = cell.y = cell.z = 0;
    cell.error = HUGE_VALF;
    return;
  }
  const double inverse = 1 / determinant;
  cell.x = (j.c * kl.x + k.c * lj.x + l.c * jk.x) * inverse;
  cell.y = (j.c * kl.y + k.c * lj.y + l.c * jk.y) * inverse;
  cell.z = (j.c * kl.z + k.c * lj.z + l.c * jk.z) * inverse;
  const double largest = std::max({std::fabs(cell.x), std::fabs(cell.y), std::fabs(cell.z)});
  // The determinant is off by less than half of it, so the true one's inverse is below 2 / D. Three
  // roundings of the quotient, four of the later product with d_m and its sum.
  const double error =
      2 * square * (56 * u * size + 32 * u * length * largest) * inverse + 8 * u * largest;
  constexpr double kMost = 1e37;  // floats end at 3e38
  cell.error = error < kMost ? static_cast<float>(1.01 * error) : HUGE_VALF;
}

// Sets the numbers of a cell at infinity. Ball m is in conflict with it where n·d_m > 0. The
// computed value errs by at most error · (|d_mx| + |d_my| + |d_mz|).
inline void certify_cell_at_infinity(const CornerBall& j, const CornerBall& k, Cell& cell) {
  const auto normal = cross(j, k);
  const double length = std::max(j.largest, k.largest);
  cell.x = normal.x;
  cell.y = normal.y;
  cell.z = normal.z;
  cell.error = static_cast<float>(12 * kUnitRoundoff * length * length);
}

}  // namespace alphascope
