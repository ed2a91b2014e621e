// Colours of alpha values: early simplices dark, late ones bright.
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "ui/picture_marks.hpp"
#include "ui/scene/ball_geometry.hpp"

namespace alphascope {

// From the smallest alpha value of what is drawn up to the complex' alpha.
class AlphaScale {
 public:
  struct Drawn {
    bool tetrahedra = true, triangles = false, edges = false;
  };
  AlphaScale(const AlphaComplex& complex, const Drawn& drawn);

  Rgb8 colour(float alpha_value) const;  // square lattice units
  Rgb8 colour_at(double share) const;    // along the colour map, 0 to 1
  double alpha_at(double share) const;   // Å², of that colour
  ColourLegend legend() const;

 private:
  // The square root spreads the crowded small values.
  float low_ = 0, high_ = 0;  // square lattice units
  Lattice lattice_;
};

}  // namespace alphascope
