// SPDX-License-Identifier: GPL-3.0-or-later
// The range of alpha values in a mesh, and colours along it.
#include "ui/scene/mesh/alpha_scale.hpp"

#include <algorithm>

#include "core/molecule/rgb8.hpp"

namespace alphascope {
namespace {

// The least alpha value of the drawn simplices, at most the complex' own alpha; square lattice
// units.
float lowest_drawn(const AlphaComplex& complex, const AlphaScale::Drawn& drawn) {
  auto low = complex.alpha_on_lattice.nearest_float();
  const auto take = [&low](const auto& list) {
    for (const float v : list.alpha_values) low = std::min(low, v);
  };
  if (drawn.tetrahedra) take(complex.tetrahedra);
  if (drawn.triangles) take(complex.triangles);
  if (drawn.edges) take(complex.edges);
  return low;
}

}  // namespace

AlphaScale::AlphaScale(const AlphaComplex& complex, const Drawn& drawn, const AlphaColours& colours)
    : scale_{colours.map, {}, scheme_info(ColourBy::alpha).root},
      angstrom2_(complex.lattice.square_angstrom(1)) {
  scale_.range = colours.range
                     ? *colours.range
                     : ColourRange{complex.lattice.square_angstrom(lowest_drawn(complex, drawn)),
                                   complex.alpha_angstrom2()};
}

Rgb8 AlphaScale::colour(float value) const {
  return scale_.colour(angstrom2_ * value);
}

Rgb8 AlphaScale::colour_at(double share) const {
  return mapped_colour(scale_.map, share);
}

double AlphaScale::alpha_at(double share) const {
  return scale_.value(share);
}

ColourMeaning AlphaScale::key() const {
  return {quantity_title(scheme_info(ColourBy::alpha)), scale_, {}};
}

}  // namespace alphascope
