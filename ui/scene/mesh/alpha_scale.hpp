// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of alpha values: simplices with low values get the beginning of the colour map.
#pragma once

#include <optional>

#include "core/complex/alpha_complex.hpp"
#include "core/document/measures/paint_balls.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

// Map and range for ColourBy::alpha.
struct AlphaColours {
  ColourMap map = scheme_info(ColourBy::alpha).map;
  std::optional<ColourRange> range;  // Å²; none: from the least value drawn to the complex' alpha
  friend bool operator==(const AlphaColours&, const AlphaColours&) = default;
};

class AlphaScale {
 public:
  struct Drawn {
    bool tetrahedra = true, triangles = false, edges = false;
  };
  AlphaScale(const AlphaComplex& complex, const Drawn& drawn, const AlphaColours& colours = {});

  Rgb8 colour(float alpha_value) const;  // square lattice units
  Rgb8 colour_at(double share) const;    // by share of the colour map, 0 to 1
  double alpha_at(double share) const;   // Å², at that share
  ColourMeaning key() const;

 private:
  ColourScale scale_;     // Å²
  double angstrom2_ = 1;  // Å² in a square lattice unit
};

}  // namespace alphascope
