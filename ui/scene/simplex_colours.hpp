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
  Rgb8 best = colours[simplex[0]];
  std::ptrdiff_t most = 0;
  for (const BallIndex v : simplex) {
    const auto same = std::count_if(simplex.begin(), simplex.end(),
                                    [&](BallIndex w) { return colours[w] == colours[v]; });
    if (same > most) {
      most = same;
      best = colours[v];
    }
  }
  return best;
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
