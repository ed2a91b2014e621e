// See the header.
#include "ui/scene/alpha_scale.hpp"

#include <algorithm>
#include <cmath>

#include "ui/scene/colour_map.hpp"

namespace alphascope {
AlphaScale::AlphaScale(const AlphaComplex& complex, const Drawn& drawn)
    : lattice_(complex.lattice) {
  low_ = high_ = static_cast<float>(complex.alpha_on_lattice);
  const auto take = [this](const auto& list) {
    for (const float v : list.alpha_values) low_ = std::min(low_, v);
  };
  if (drawn.tetrahedra) take(complex.tetrahedra);
  if (drawn.triangles) take(complex.triangles);
  if (drawn.edges) take(complex.edges);
}

Rgb8 AlphaScale::colour(float value) const {
  if (!(high_ > low_)) return colour_at(0.5);
  return colour_at(std::sqrt(std::max(0.0f, (value - low_) / (high_ - low_))));
}

Rgb8 AlphaScale::colour_at(double share) const {
  return mapped_colour(share);
}

double AlphaScale::alpha_at(double share) const {
  const double low = low_, high = high_;
  return lattice_.square_angstrom(low + share * share * (high - low));
}

ColourLegend AlphaScale::legend() const {
  return map_legend("alpha value (Å²), square-root scale",
                    [this](double share) { return alpha_at(share); });
}

}  // namespace alphascope
