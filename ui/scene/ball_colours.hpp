// One colour a ball: by element, by chain or by a share. Knows the molecule; no VTK.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "ui/picture_marks.hpp"
#include "ui/scene/ball_geometry.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// `atom_of_ball` as in PreparedBalls: an index into the molecule's atoms for each ball.
std::vector<Rgb8> colours_by_element(const Molecule& molecule,
                                     const std::vector<std::uint32_t>& atom_of_ball);
// Chains in the order in which the molecule has them; the colours repeat after ten.
std::vector<Rgb8> colours_by_chain(const Molecule& molecule,
                                   const std::vector<std::uint32_t>& atom_of_ball);

// By a number from 0 to 1 for each ball, along the map of colour_map.hpp. The square root spreads
// small shares, which nearly all are.
std::vector<Rgb8> colours_by_share(const std::vector<float>& shares);
ColourLegend share_legend(const std::string& quantity);  // in percent

Rgb8 element_colour(Element element);

Rgb8 to_rgb8(const Colour& colour);

}  // namespace alphascope
