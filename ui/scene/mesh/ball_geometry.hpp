// SPDX-License-Identifier: GPL-3.0-or-later
// Balls for graphics: floats in Å around an origin near their middle. A float would lose digits of
// the lattice's large coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/molecule/atom_colours.hpp"

namespace alphascope {

struct BallGeometry {
  std::array<double, 3> origin{};             // Å, in the file's coordinates
  std::vector<std::array<float, 3>> centres;  // Å, relative to origin
  std::vector<float> radii;                   // Å, as in the BallSet
  // Box around the balls (Å, relative to origin): xmin, xmax, ymin, ymax, zmin, zmax.
  std::array<double, 6> bounds{-1, 1, -1, 1, -1, 1};
  // Unit vectors of decreasing spread: right, up and towards the viewer of the default view.
  std::array<std::array<double, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  int dimension = 3;  // of the space that the centres span

  explicit BallGeometry(const BallSet& balls);
  BallGeometry() = default;
};

// Radii as drawn.
struct BallStyle {
  bool grown = false;         // sqrt((radius + solvent)² + alpha) instead of the radius
  double scale = 0.3;         // factor on that radius
  double solvent_radius = 0;  // Å
  double alpha = 0;           // Å²
};

// Radius of each ball as drawn (Å); 0 where the grown ball is empty (alpha < -(radius + solvent)²).
std::vector<float> drawn_radii(const BallGeometry& balls, const BallStyle& style);

}  // namespace alphascope
