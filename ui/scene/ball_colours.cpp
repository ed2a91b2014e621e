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

std::vector<Rgb8> colours_by_exposure(const ExposureColours& of, const Molecule& molecule,
                                      const std::vector<std::uint32_t>& atom_of_ball) {
  return colours_by_share(of.colour == ColourBy::exposed
                              ? exposed_shares(of.measures, of.balls, of.alpha_on_lattice)
                              : exposed_shares_of_residues(of.measures, of.balls,
                                                           of.alpha_on_lattice, molecule,
                                                           atom_of_ball));
}

ColourLegend exposure_legend(ColourBy colour) {
  return share_legend(colour == ColourBy::exposed ? "exposed area of atoms"
                                                  : "exposed area of residues");
}

}  // namespace alphascope
