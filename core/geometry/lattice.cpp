// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of alpha to square lattice units and back.
#include "core/geometry/lattice.hpp"

#include <string>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

LatticeAlpha Lattice::alpha_on_lattice(const Alpha& alpha) const {
  if (!alpha.is_decimal()) return alpha.nearest() * std::pow(10.0, 2 * digits);
  // whole · 10^(2 digits) is at most 10^36, and fraction · 10^(2 digits) below 10^30.
  Int128 factor = 1;
  for (int n = 0; n < 2 * digits; ++n) factor *= 10;
  const Int128 parts = alpha.fraction() * factor;
  return LatticeAlpha::of(alpha.whole() * factor + parts / Alpha::kParts,
                          static_cast<std::int64_t>(parts % Alpha::kParts));
}

Alpha Lattice::alpha_angstrom2(const LatticeAlpha& alpha) const {
  Alpha read;
  const std::string digits_of = alpha.text();
  const bool plain = digits_of.find_first_not_of("-0123456789.") == std::string::npos;
  const std::string text = digits_of + "e-" + std::to_string(2 * digits);
  if (plain && Alpha::read(text, read) == Alpha::Reading::ok) return read;
  return square_angstrom(alpha.nearest());
}

}  // namespace alphascope
