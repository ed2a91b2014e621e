// What a face has from its cofaces: whether it is in K_alpha, its alpha value, its class, and the
// alphas from which on the class holds. This is the only place that says so; each engine reads the
// cofaces from where it keeps them. Host and device.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// Where a simplex lies in K_alpha: singular = face of no other simplex of K_alpha; regular = on the
// boundary of K_alpha and face of another; interior = its whole neighbourhood is filled.
enum class SimplexClass : std::uint8_t { singular, regular, interior };

// What is known of a face at one alpha, as flags. The flags from several cofaces are joined with
// "or", in any order. A tetrahedron has no coface and is interior.
inline constexpr std::uint32_t kHasCoface = 1;          // in K_alpha
inline constexpr std::uint32_t kHasBoundaryCoface = 2;  // one in K_alpha that is not interior
// No ball cuts off the face's own orthocentre, and its ortho-radius is at most alpha.
inline constexpr std::uint32_t kUnattached = 4;

// What a coface in K_alpha says.
ALPHASCOPE_INLINE constexpr std::uint32_t coface_flags(SimplexClass coface) {
  return coface == SimplexClass::interior ? kHasCoface : kHasCoface | kHasBoundaryCoface;
}
// What the tetrahedra of a triangle in K_alpha say, 0 to 2: with one, its other side is empty.
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
// The same of a triangle with so many tetrahedra in K_alpha. The number is the class.
ALPHASCOPE_INLINE constexpr SimplexClass triangle_class(int tetrahedra) {
  static_assert(face_class(triangle_flags(0)) == SimplexClass{0} &&
                face_class(triangle_flags(1)) == SimplexClass{1} &&
                face_class(triangle_flags(2)) == SimplexClass{2});
  return static_cast<SimplexClass>(tetrahedra);
}
// The alpha value of a face in K_alpha: its ortho-radius, which own() gives, or, if it is attached,
// the least value of its cofaces.
template <class Own>
ALPHASCOPE_INLINE float face_value(std::uint32_t flags, float least, const Own& own) {
  return flags & kUnattached ? own() : least;
}

// An alpha that no complex reaches: every comparison with it fails.
inline constexpr float kNever = std::numeric_limits<float>::quiet_NaN();

// For all alphas at once: those from which on a face is regular and interior, square lattice units,
// of the cofaces that were added. Without any, both are kNever (none()).
struct FaceLevels {
  float regular_from = std::numeric_limits<float>::infinity();
  float interior_from = -std::numeric_limits<float>::infinity();

  static FaceLevels none() { return {kNever, kNever}; }
  // `coface_interior_from`: of a tetrahedron its alpha value.
  void add(float coface_value, float coface_interior_from) {
    regular_from = coface_value < regular_from ? coface_value : regular_from;
    if (std::isnan(coface_interior_from) || std::isnan(interior_from)) {
      interior_from = kNever;
    } else {
      interior_from = interior_from < coface_interior_from ? coface_interior_from : interior_from;
    }
  }
  // The face is a triangle of the hull of all balls: its other side is never filled.
  void lie_on_hull() { interior_from = kNever; }
};

// The class of a simplex in the complex of all simplices of alpha values <= `bound`; it is one.
inline SimplexClass class_at(const FaceLevels& levels, float bound) {
  // Without a branch, which would be guessed wrong half of the time.
  const int regular = levels.regular_from <= bound;
  return static_cast<SimplexClass>(regular + (regular & (levels.interior_from <= bound)));
}

}  // namespace alphascope
