// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of quantities and of categories: published maps that colour-blind people can read.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace alphascope {

enum class ColourMap : std::uint8_t { viridis, cividis, blue_white_red, rainbow };
struct Rgb8;
inline constexpr std::array kColourMaps = {ColourMap::viridis, ColourMap::cividis,
                                           ColourMap::blue_white_red, ColourMap::rainbow};

struct ColourMapInfo {
  const char* id;     // "viridis"
  const char* title;  // "Viridis"
  const char* help;   // a sentence without full stop
};
const ColourMapInfo& colour_map_info(ColourMap map);
std::optional<ColourMap> colour_map_named(std::string_view id);
std::string colour_map_ids();  // "viridis|cividis|..."

// The colour at a share of the map: 0 is its first colour, 1 its last. Shares beyond are clamped.
Rgb8 mapped_colour(ColourMap map, double share);

// The colour of the n-th cavity, used everywhere. Cavity colours are stronger than those of chains,
// and none of these is similar. Repeats after kCavityColours.
Rgb8 cavity_colour(std::size_t n);
inline constexpr std::size_t kCavityColours = 8;

}  // namespace alphascope
