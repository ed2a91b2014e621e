// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps as straight lines between entries of published tables.
#include "core/chart/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/chart/chart.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {
namespace {

// Viridis (Smith and van der Walt, matplotlib 2.0), CC0, every 32nd of its 256 entries.
constexpr Rgb8 kViridis[] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                             {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                             {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};

// Cividis (Nuñez, Anderton and Renslow, PLoS ONE 13, e0199239, 2018), every 32nd of its 256
// entries.
constexpr Rgb8 kCividis[] = {{0, 34, 78},     {26, 56, 111},   {67, 78, 108},
                             {97, 101, 111},  {125, 124, 120}, {155, 148, 118},
                             {188, 174, 108}, {222, 201, 88},  {254, 232, 56}};

// ColorBrewer's RdBu of eleven classes (Brewer, colorbrewer2.org), reversed: from blue to red.
constexpr Rgb8 kBlueWhiteRed[] = {{5, 48, 97},     {33, 102, 172},  {67, 147, 195},
                                  {146, 197, 222}, {209, 229, 240}, {247, 247, 247},
                                  {253, 219, 199}, {244, 165, 130}, {214, 96, 77},
                                  {178, 24, 43},   {103, 0, 31}};

// Tol's smooth rainbow from purple to red (SRON technical note EPS/TN/09-002, 3.2, 2021).
constexpr Rgb8 kRainbow[] = {{111, 76, 155}, {96, 89, 169},   {85, 104, 184},  {78, 121, 197},
                             {77, 138, 198}, {78, 150, 188},  {84, 158, 179},  {89, 165, 169},
                             {96, 171, 158}, {105, 177, 144}, {119, 183, 125}, {140, 188, 104},
                             {166, 190, 84}, {190, 188, 72},  {209, 181, 65},  {221, 170, 60},
                             {228, 156, 57}, {231, 140, 53},  {230, 121, 50},  {228, 99, 45},
                             {223, 72, 40},  {218, 34, 34}};

std::span<const Rgb8> table(ColourMap map) {
  switch (map) {
    case ColourMap::viridis:
      return kViridis;
    case ColourMap::cividis:
      return kCividis;
    case ColourMap::blue_white_red:
      return kBlueWhiteRed;
    case ColourMap::rainbow:
      break;
  }
  return kRainbow;
}

}  // namespace

const ColourMapInfo& colour_map_info(ColourMap map) {
  static constexpr ColourMapInfo kInfos[] = {
      {"viridis", "Viridis", "From dark violet through green to yellow, ever brighter"},
      {"cividis", "Cividis", "From dark blue to yellow, the same for colour-blind eyes"},
      {"blue_white_red", "Blue, white, red", "From blue through white to red"},
      {"rainbow", "Rainbow",
       "From purple through green to red; shows an order, but amounts cannot be compared"}};
  return kInfos[static_cast<std::size_t>(map)];
}

std::optional<ColourMap> colour_map_named(std::string_view id) {
  for (const ColourMap map : kColourMaps) {
    if (colour_map_info(map).id == id) return map;
  }
  return std::nullopt;
}

std::string colour_map_ids() {
  std::string ids;
  for (const ColourMap map : kColourMaps) {
    ids += (ids.empty() ? "" : "|") + std::string(colour_map_info(map).id);
  }
  return ids;
}

Rgb8 mapped_colour(ColourMap map, double share) {
  const std::span<const Rgb8> colours = table(map);
  const auto last = static_cast<double>(colours.size() - 1);
  const double x = share > 0 ? std::min(share, 1.0) * last : 0;  // 0 for NaN
  const std::size_t i = std::min(colours.size() - 2, static_cast<std::size_t>(x));
  const double f = x - static_cast<double>(i);
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
  };
  const Rgb8 &a = colours[i], &b = colours[i + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

// These colours were found together with those of chains; see core/molecule/atom_colours.cpp.
Rgb8 cavity_colour(std::size_t n) {
  constexpr std::array<Rgb8, kCavityColours> kColours{{{247, 198, 22},
                                                       {138, 113, 255},
                                                       {234, 45, 94},
                                                       {19, 204, 125},
                                                       {230, 143, 255},
                                                       {255, 60, 177},
                                                       {253, 0, 1},
                                                       {241, 139, 0}}};
  return kColours[n % kColours.size()];
}

}  // namespace alphascope
