// The colour of a simplex in the picture. For sources of the scene only.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "ui/scene/mesh/alpha_scale.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// On a tie the corner with the lowest index decides: a simplex lists its corners in rising order.
// Without a branch, which the processor would often guess wrong.
template <std::size_t N>
Rgb8 most_frequent_colour(const std::array<BallIndex, N>& simplex,
                          const std::vector<Rgb8>& colours) {
  static_assert(N <= 4);
  std::array<PackedColour, N> of;
  for (std::size_t i = 0; i < N; ++i) of[i] = packed(colours[simplex[i]]);
  // If others have the colour of the first, at most as many have another: it stays. Else a later
  // one wins if two have it, and of four corners no two such pairs are left.
  bool first_is_alone = true;
  for (std::size_t i = 1; i < N; ++i) first_is_alone &= of[i] != of[0];
  PackedColour most = of[0];
  for (std::size_t i = 1; i < N; ++i) {
    bool has_more = false;
    for (std::size_t k = i + 1; k < N; ++k) has_more |= of[k] == of[i];
    most = first_is_alone & has_more ? of[i] : most;
  }
  return unpacked(most);
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
