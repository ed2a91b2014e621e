// The colour of a simplex in the picture. For sources of the scene only.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "ui/scene/alpha_scale.hpp"
#include "ui/scene/complex_mesh.hpp"

namespace alphascope {

// On a tie the corner with the lowest index decides: a simplex lists its corners in rising order.
template <std::size_t N>
Rgb8 most_frequent_colour(const std::array<BallIndex, N>& simplex,
                          const std::vector<Rgb8>& colours) {
  std::array<PackedColour, N> of;
  for (std::size_t i = 0; i < N; ++i) of[i] = packed(colours[simplex[i]]);
  std::size_t best = 0;
  std::ptrdiff_t most = 0;
  for (std::size_t i = 0; i < N && most <= static_cast<std::ptrdiff_t>(N / 2); ++i) {
    const auto same = std::count(of.begin(), of.end(), of[i]);
    if (same > most) {
      most = same;
      best = i;
    }
  }
  return colours[simplex[best]];
}

// Of a simplex; only colours of their own kinds look at it.
struct SimplexTraits {
  float alpha_value = 0;  // square lattice units
  SimplexClass of_class = SimplexClass::interior;
};

// `scale` is used where colours are of alpha values only, and `colours` (one a ball) where they are
// of balls.
template <std::size_t N>
Rgb8 simplex_colour(const std::array<BallIndex, N>& simplex, const SimplexTraits& traits,
                    const MeshOptions& options, const std::vector<Rgb8>& colours,
                    const AlphaScale* scale) {
  switch (options.colouring) {
    case ComplexColouring::balls:
      return most_frequent_colour(simplex, colours);
    case ComplexColouring::alpha:
      return scale->colour(traits.alpha_value);
    case ComplexColouring::classes:
      return class_colour(traits.of_class);
    case ComplexColouring::single:
      break;
  }
  return options.single_colour;
}

}  // namespace alphascope
