// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the envelope of a ball set and tests points against it.
#include "core/channel/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alphascope {

Envelope::Envelope(const BallSet& balls) {
  // Directions spread evenly over the sphere: each is turned from the last by the golden angle.
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  const double unit = balls.lattice.unit_angstrom();
  for (std::size_t n = 0; n < kSides; ++n) {
    const double z = 1 - (2 * static_cast<double>(n) + 1) / static_cast<double>(kSides);
    const double radius = std::sqrt(1 - z * z), angle = turn * static_cast<double>(n);
    Side& side = sides_[n];
    side.outwards = {radius * std::cos(angle), radius * std::sin(angle), z};
    side.most = -std::numeric_limits<double>::infinity();
    for (const LatticePoint& p : balls.centres) {
      side.most = std::max(side.most, unit * dot(side.outwards, real_point(p)));
    }
  }
}

bool Envelope::holds(const RealPoint& x) const {
  return std::all_of(sides_.begin(), sides_.end(),
                     [&](const Side& side) { return dot(side.outwards, x) <= side.most; });
}

RealPoint Envelope::outwards(const RealPoint& x) const {
  const auto beyond = [&](const Side& side) { return dot(side.outwards, x) - side.most; };
  return std::max_element(sides_.begin(), sides_.end(),
                          [&](const Side& a, const Side& b) { return beyond(a) < beyond(b); })
      ->outwards;
}

}  // namespace alphascope
