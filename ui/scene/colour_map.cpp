#include "ui/scene/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alphascope {
namespace {

// Viridis (Smith and van der Walt, matplotlib 2.0), CC0, every 32nd of its 256 entries.
constexpr Rgb8 kViridis[9] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                              {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                              {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};

}  // namespace

Rgb8 mapped_colour(double share) {
  const double x = std::clamp(share, 0.0, 1.0) * 8;
  const int i = std::min(7, static_cast<int>(x));
  const double f = x - i;
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
  };
  const Rgb8 &a = kViridis[i], &b = kViridis[i + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

ColourLegend map_legend(std::string title, const std::function<double(double)>& value) {
  constexpr int kStops = 33;  // the map's nine colours, and three between each two
  ColourLegend legend{std::move(title), {}};
  for (int i = 0; i < kStops; ++i) {
    const double share = static_cast<double>(i) / (kStops - 1);
    const Rgb8 c = mapped_colour(share);
    legend.stops.push_back({{c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, 1.0f}, value(share)});
  }
  return legend;
}

}  // namespace alphascope
