// SPDX-License-Identifier: GPL-3.0-or-later
// The rules by which a face follows from its cofaces: whether it is in K_alpha, its alpha value,
// its class, and the alphas from which on the class holds. Every engine uses these rules, and reads
// the cofaces from its own data. Host and device.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// The class of a simplex of K_alpha. singular: face of no other simplex of K_alpha. regular: on the
// boundary of K_alpha, and face of another. interior: its whole neighbourhood is filled.
enum class SimplexClass : std::uint8_t { singular, regular, interior };

// Facts about a face at one alpha, as flags. The flags that several cofaces give to a face are
// combined by "or", in any order. A tetrahedron has no coface and is always interior.
inline constexpr std::uint32_t kHasCoface = 1;  // a coface is in K_alpha
// A coface is in K_alpha and is not interior.
inline constexpr std::uint32_t kHasBoundaryCoface = 2;
// No ball cuts off the face's own orthocentre, and its ortho-radius is at most alpha.
inline constexpr std::uint32_t kUnattached = 4;

// The flags that a coface in K_alpha gives to its faces.
ALPHASCOPE_INLINE constexpr std::uint32_t coface_flags(SimplexClass coface) {
  return coface == SimplexClass::interior ? kHasCoface : kHasCoface | kHasBoundaryCoface;
}
// The flags of a triangle with 0 to 2 tetrahedra in K_alpha. A triangle with one of them has an
// empty side.
ALPHASCOPE_INLINE constexpr std::uint32_t triangle_flags(std::size_t tetrahedra) {
  return tetrahedra == 0 ? 0 : tetrahedra == 1 ? kHasCoface | kHasBoundaryCoface : kHasCoface;
}

// K_alpha is the closure of its unattached simplices.
ALPHASCOPE_INLINE constexpr bool is_in_complex(std::uint32_t flags) {
  return (flags & (kUnattached | kHasCoface)) != 0;
}
ALPHASCOPE_INLINE constexpr SimplexClass face_class(std::uint32_t flags) {
  return !(flags & kHasCoface)          ? SimplexClass::singular
         : (flags & kHasBoundaryCoface) ? SimplexClass::regular
                                        : SimplexClass::interior;
}
// The class of a triangle by the number of its tetrahedra in K_alpha. The number is the value of
// the class.
ALPHASCOPE_INLINE constexpr SimplexClass triangle_class(int tetrahedra) {
  static_assert(face_class(triangle_flags(0)) == SimplexClass{0} &&
                face_class(triangle_flags(1)) == SimplexClass{1} &&
                face_class(triangle_flags(2)) == SimplexClass{2});
  return static_cast<SimplexClass>(tetrahedra);
}
// The alpha value of a face in K_alpha: its ortho-radius own() or, if it is attached, the least
// value of its cofaces.
template <class Own>
ALPHASCOPE_INLINE float face_value(std::uint32_t flags, float least, const Own& own) {
  return flags & kUnattached ? own() : least;
}

// Marks a level that no alpha reaches: every comparison with NaN is false.
inline constexpr float kNever = std::numeric_limits<float>::quiet_NaN();

// The levels of a face, from the cofaces that were added: the alphas from which on it is regular
// and interior, in square lattice units. For a face without cofaces both are kNever (none()).
struct FaceLevels {
  float regular_from = HUGE_VALF;
  float interior_from = -HUGE_VALF;

  static FaceLevels none() { return {kNever, kNever}; }
  // Adds a coface. `coface_interior_from` is the level of the coface; for a tetrahedron, its alpha
  // value.
  ALPHASCOPE_INLINE void add(float coface_value, float coface_interior_from) {
    regular_from = coface_value < regular_from ? coface_value : regular_from;
    if (std::isnan(coface_interior_from) || std::isnan(interior_from)) {
      interior_from = kNever;
    } else {
      interior_from = interior_from < coface_interior_from ? coface_interior_from : interior_from;
    }
  }
  // For a triangle on the hull of all balls: its other side is never filled.
  ALPHASCOPE_INLINE void lie_on_hull() { interior_from = kNever; }
};

// The class of a simplex in the complex of all simplices with alpha values <= `bound`. The simplex
// must be one of these.
ALPHASCOPE_INLINE SimplexClass class_at(const FaceLevels& levels, float bound) {
  // This code has no branch, because a processor would predict about half of the branches wrongly.
  const int regular = levels.regular_from <= bound;
  return static_cast<SimplexClass>(regular + (regular & (levels.interior_from <= bound)));
}

}  // namespace alphascope
