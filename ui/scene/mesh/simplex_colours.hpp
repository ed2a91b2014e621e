// SPDX-License-Identifier: GPL-3.0-or-later
// The colour of a simplex in the picture. For sources of the scene only.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "ui/scene/mesh/alpha_scale.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// On a tie the corner with the lowest index wins, since a simplex lists its corners in rising
// order. There is no branch, because the processor would often guess it wrong.
template <std::size_t N>
Rgb8 most_frequent_colour(const std::array<BallIndex, N>& simplex,
                          const std::vector<Rgb8>& colours) {
  static_assert(N <= 4);
  std::array<PackedColour, N> of;
  for (std::size_t i = 0; i < N; ++i) of[i] = packed(colours[simplex[i]]);
  // If another corner has the colour of the first, at most two corners share another colour, so the
  // first wins. Otherwise a later colour wins if two corners have it. At most one such pair is
  // possible among the three other corners.
  bool first_is_alone = true;
  for (std::size_t i = 1; i < N; ++i) first_is_alone &= of[i] != of[0];
  PackedColour most = of[0];
  for (std::size_t i = 1; i < N; ++i) {
    bool has_more = false;
    for (std::size_t k = i + 1; k < N; ++k) has_more |= of[k] == of[i];
    most = (first_is_alone & has_more) ? of[i] : most;
  }
  return unpacked(most);
}

// Traits that colourings by alpha value and by class use.
struct SimplexTraits {
  float alpha_value = 0;  // square lattice units
  SimplexClass of_class = SimplexClass::interior;
};

// `scale` is used for colours of alpha values only, `colours` (one for each ball) for colours of
// balls only.
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
