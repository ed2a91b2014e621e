// One colour a ball: by element or by chain (core/molecule/atom_colours.hpp), or by a share. No
// VTK.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/molecule/atom_colours.hpp"
#include "ui/picture_marks.hpp"
#include "ui/scene/ball_geometry.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// By a number from 0 to 1 for each ball, along the map of colour_map.hpp. The square root spreads
// small shares, which nearly all are.
std::vector<Rgb8> colours_by_share(const std::vector<float>& shares);
ColourLegend share_legend(const std::string& quantity);  // in percent

Rgb8 to_rgb8(const Colour& colour);

}  // namespace alphascope
