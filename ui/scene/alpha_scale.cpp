// See the header.
#include "ui/scene/alpha_scale.hpp"

#include <algorithm>
#include <cmath>

namespace alphascope {
namespace {

// Viridis (Smith and van der Walt, matplotlib 2.0), CC0, every 32nd of its 256 entries.
constexpr Rgb8 kViridis[9] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                              {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                              {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};

}  // namespace

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
  const double x = std::clamp(share, 0.0, 1.0) * 8;
  const int i = std::min(7, static_cast<int>(x));
  const double f = x - i;
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
  };
  const Rgb8 &a = kViridis[i], &b = kViridis[i + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

double AlphaScale::alpha_at(double share) const {
  const double low = low_, high = high_;
  return lattice_.square_angstrom(low + share * share * (high - low));
}

ColourLegend AlphaScale::legend() const {
  constexpr int kStops = 33;  // the map's nine colours, and three between each two
  ColourLegend legend;
  for (int i = 0; i < kStops; ++i) {
    const double share = static_cast<double>(i) / (kStops - 1);
    const Rgb8 c = colour_at(share);
    legend.stops.push_back({{c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, 1.0f}, alpha_at(share)});
  }
  return legend;
}

}  // namespace alphascope
