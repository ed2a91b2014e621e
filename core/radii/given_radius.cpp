// SPDX-License-Identifier: GPL-3.0-or-later
// Puts given radii on a lattice, and refines the lattice if that avoids rounding.
#include "core/radii/given_radius.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {
namespace {

constexpr int kGivenDigits = 6;

}  // namespace

LatticeRadius on_lattice(std::int32_t microangstrom, const Lattice& lattice) {
  std::int64_t step = 1;  // 10^-6 Å per lattice unit
  for (int digits = lattice.digits; digits < kGivenDigits; ++digits) step *= 10;
  // At least one unit, so that no ball vanishes on a lattice of whole ångströms.
  const std::int64_t units =
      std::clamp<std::int64_t>((microangstrom + step / 2) / step, 1, kMaxLatticeRadius);
  const auto change = static_cast<double>(std::llabs(units * step - microangstrom));
  return {static_cast<std::int32_t>(units), change * 1e-6};
}

RadiusRounding fit_lattice(BallSet& balls, const std::vector<RoundedBall>& rounded) {
  int wanted = balls.lattice.digits;
  for (const RoundedBall& r : rounded) {
    while (wanted < kMaxLatticeDigits &&
           on_lattice(r.microangstrom, Lattice{wanted}).rounding_angstrom > 0) {
      ++wanted;
    }
  }
  const int digits = finest_digits(balls, wanted, 0);
  if (digits > balls.lattice.digits) balls = on_finer_lattice(balls, digits);
  RadiusRounding result;
  for (const RoundedBall& r : rounded) {
    const LatticeRadius radius = on_lattice(r.microangstrom, balls.lattice);
    balls.radii[r.ball] = radius.units;
    result.balls += radius.rounding_angstrom > 0;
    result.largest_angstrom = std::max(result.largest_angstrom, radius.rounding_angstrom);
  }
  return result;
}

}  // namespace alphascope
