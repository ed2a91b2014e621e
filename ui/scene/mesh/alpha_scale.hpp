// Colours of alpha values: early simplices at the map's beginning, late ones at its end.
#pragma once

#include <optional>

#include "core/complex/alpha_complex.hpp"
#include "core/document/measures/paint_balls.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

// Of ColourBy::alpha.
struct AlphaColours {
  ColourMap map = scheme_info(ColourBy::alpha).map;
  std::optional<ColourRange> range;  // Å²; none: from the smallest value drawn up to alpha
  friend bool operator==(const AlphaColours&, const AlphaColours&) = default;
};

class AlphaScale {
 public:
  struct Drawn {
    bool tetrahedra = true, triangles = false, edges = false;
  };
  AlphaScale(const AlphaComplex& complex, const Drawn& drawn, const AlphaColours& colours = {});

  Rgb8 colour(float alpha_value) const;  // square lattice units
  Rgb8 colour_at(double share) const;    // along the colour map, 0 to 1
  double alpha_at(double share) const;   // Å², of that colour
  PaintKey key() const;

 private:
  ColourScale scale_;     // Å²
  double angstrom2_ = 1;  // of a square lattice unit
};

}  // namespace alphascope
