// SPDX-License-Identifier: GPL-3.0-or-later
// Writes positions and radii with as many decimals as are meaningful.
#include "ui/panels/explain/ball_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/settings/request.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/grown_radius.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"
#include "ui/number_text.hpp"

namespace alphascope {

std::string place_text(const LatticePoint& point, const Lattice& lattice) {
  const int digits = std::clamp(lattice.digits, 0, 4);
  const auto coordinate = [&](std::int32_t x) {
    return short_number_text(lattice.angstrom(x), digits);
  };
  return coordinate(point.x) + ", " + coordinate(point.y) + ", " + coordinate(point.z);
}

std::string radius_text(const BallSet& balls, const Request* shown, BallIndex ball) {
  const double radius = balls.lattice.angstrom(balls.radii[ball]);
  // Both numbers have equally many decimals; else one would seem to be known better.
  const int decimals = std::fabs(radius - std::round(radius * 100) / 100) > 1e-6 ? 3 : 2;
  const std::string text = "radius " + number_text(radius, decimals) + " Å";
  if (shown == nullptr) return text;
  const double grown = grown_radius(radius, shown->solvent_radius_angstrom, shown->alpha_angstrom2);
  if (grown == 0) return text + ", empty at this alpha";
  return text + ", grown " + number_text(grown, decimals) + " Å";
}

}  // namespace alphascope
