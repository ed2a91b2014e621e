// SPDX-License-Identifier: GPL-3.0-or-later
// Texts on channels, for window and command line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

const char* channel_limit_text(ChannelLimit limit);  // the end of a sentence: "between …"
const char* channel_limit_id(ChannelLimit limit);

// Number of waters that pass side by side. The limits are those of HOLE's colours red, green and
// blue: O. S. Smart, J. G. Neduvelil, X. Wang, B. A. Wallace, M. S. P. Sansom, J. Mol. Graph. 14,
// 1996.
enum class WaterBand : std::uint8_t { none, one, several };
inline constexpr double kOneWaterAngstrom = 1.15, kTwoWatersAngstrom = 2.30;
WaterBand water_band(double radius_angstrom);
const char* water_band_text(WaterBand band);  // "no water passes"
// Colour of the tube and of the profile's bands.
Rgb8 water_band_colour(WaterBand band);

// The radius of the largest ball that passes, rounded down to 0.001 Å: "0.846". It is negative for
// a closed channel. Window, command line and files give this number.
std::string bottleneck_radius_text(const Channel& channel);

// The waters that can pass a channel through the whole molecule. For other channels the text says
// that there is no verdict.
std::string passing_waters_text(const FoundChannel& found);
// "84.8 of 116.2 Å of the molecule"
std::string cover_text(const WayCover& cover);
// "A, B, C, D"
std::string chains_text(const std::vector<std::string>& chains);
// "4 ions, 12 atoms of ligands"; empty if there are none
std::string pore_contents_text(const WayFacts& way);

// "A:VAL 1:CA, A:GLY 2:O"
std::string touching_text(const BallReferences& atoms, const Channel& channel);

}  // namespace alphascope
