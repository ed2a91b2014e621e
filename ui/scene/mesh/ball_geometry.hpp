// Balls as floats in Å around an origin near their middle, as graphics needs them: the lattice's
// large coordinates would lose digits in a float.
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

  int dimension = 3;  // of what the centres span

  explicit BallGeometry(const BallSet& balls);
  BallGeometry() = default;
};

// How large balls are drawn.
struct BallStyle {
  bool grown = false;         // sqrt((radius + solvent)² + alpha) instead of the radius
  double scale = 0.3;         // times that
  double solvent_radius = 0;  // Å
  double alpha = 0;           // Å²
  friend bool operator==(const BallStyle&, const BallStyle&) = default;
};

// Radius in Å of every ball as drawn; 0 where the grown ball is empty (alpha < -radius²).
std::vector<float> drawn_radii(const BallGeometry& balls, const BallStyle& style);

}  // namespace alphascope
