// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that a measurement of a union of balls gives, for each ball and in total. Sums,
// kernels, copies and totals loop over this list; the terms of each quantity are in
// simplex_terms.hpp. Host and device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// arc_length: of the arcs on the surface in which two spheres meet, half of it for each ball.
enum class MeasuredQuantity : std::uint8_t { area, volume, arc_length };
inline constexpr int kMeasuredQuantities = 3;

// A value of each quantity.
template <class T>
struct PerQuantity {
  T of[kMeasuredQuantities];

  ALPHASCOPE_INLINE constexpr T& operator[](MeasuredQuantity q) { return of[static_cast<int>(q)]; }
  ALPHASCOPE_INLINE constexpr const T& operator[](MeasuredQuantity q) const {
    return of[static_cast<int>(q)];
  }
  friend bool operator==(const PerQuantity&, const PerQuantity&) = default;
};

template <class Visit, std::size_t... N>
ALPHASCOPE_INLINE void each_quantity_of(std::index_sequence<N...>, const Visit& visit) {
  (visit(static_cast<MeasuredQuantity>(N)), ...);
}
// Calls visit(quantity) for each quantity in order. The loop is unrolled when it is compiled.
template <class Visit>
ALPHASCOPE_INLINE void each_quantity(const Visit& visit) {
  each_quantity_of(std::make_index_sequence<kMeasuredQuantities>(), visit);
}

// The power of a length that a quantity is: 2 for an area, in Å².
ALPHASCOPE_INLINE constexpr int power_of_length(MeasuredQuantity q) {
  switch (q) {
    case MeasuredQuantity::area:
      return 2;
    case MeasuredQuantity::arc_length:
      return 1;
    case MeasuredQuantity::volume:
      break;
  }
  return 3;
}

// The exponent of a power of two above every term of a quantity, in units of the grown radius R to
// power_of_length(). No angle is above 2 pi, and no length above 2 R. A whole sum may have four
// times as much. A term of arcs is below 8 R, but a ball can meet n others, with n below 2^32. They
// cut caps of angular radius t off its sphere, with arcs of length l on the surface. The sectors
// between arcs and poles do not overlap, so the sum of l tan(t / 2) is at most 4 pi R. No l is
// above 4 pi R tan(t / 2). So all arcs have at most 4 pi R sqrt(n), and half of it is below 2^19 R.
ALPHASCOPE_INLINE constexpr int term_bits(MeasuredQuantity q) {
  switch (q) {
    case MeasuredQuantity::area:
      return 6;
    case MeasuredQuantity::arc_length:
      return 17;
    case MeasuredQuantity::volume:
      break;
  }
  return 5;
}

// The name and unit of a quantity, for people and for files.
struct QuantityName {
  const char *word, *unit, *key;
};
constexpr QuantityName quantity_name(MeasuredQuantity q) {
  switch (q) {
    case MeasuredQuantity::area:
      return {"area", "Å²", "area_angstrom2"};
    case MeasuredQuantity::arc_length:
      return {"arcs", "Å", "arc_length_angstrom"};
    case MeasuredQuantity::volume:
      break;
  }
  return {"volume", "Å³", "volume_angstrom3"};
}

}  // namespace alphascope
