// See the header.
#include "ui/scene/ball_colours.hpp"

#include <cmath>

#include "ui/scene/colour_map.hpp"

namespace alphascope {

Rgb8 to_rgb8(const Colour& c) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(x * 255)); };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

std::vector<Rgb8> colours_by_share(const std::vector<float>& shares) {
  std::vector<Rgb8> colours;
  colours.reserve(shares.size());
  for (const float share : shares) colours.push_back(mapped_colour(std::sqrt(share)));
  return colours;
}

ColourLegend share_legend(const std::string& quantity) {
  return map_legend(quantity + " (%), square-root scale",
                    [](double share) { return 100 * share * share; });
}

}  // namespace alphascope
