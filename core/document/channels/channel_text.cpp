// SPDX-License-Identifier: GPL-3.0-or-later
// Makes texts on channels: what passes, how much is covered, which atoms touch. Also the colours of
// bands of width.
#include "core/document/channels/channel_text.hpp"

#include <cstdio>

#include "core/chart/readable_number.hpp"
#include "core/complex/face_class.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/selection/atom_address.hpp"
#include "core/text/fixed_digits.hpp"

namespace alphascope {

const char* channel_limit_text(ChannelLimit limit) {
  switch (limit) {
    case ChannelLimit::passage:
      return "between the atoms that touch it";
    case ChannelLimit::end:
      return "at a given point: the way is wider everywhere else";
    case ChannelLimit::plane:
      break;
  }
  return "at the plane through the point: another point in the channel, or another direction, may "
         "find a wider way";
}

const char* channel_limit_id(ChannelLimit limit) {
  return limit == ChannelLimit::passage ? "passage" : limit == ChannelLimit::end ? "end" : "plane";
}

WaterBand water_band(double radius_angstrom) {
  return radius_angstrom < kOneWaterAngstrom    ? WaterBand::none
         : radius_angstrom < kTwoWatersAngstrom ? WaterBand::one
                                                : WaterBand::several;
}

const char* water_band_text(WaterBand band) {
  return band == WaterBand::none  ? "no water passes"
         : band == WaterBand::one ? "one water passes at a time"
                                  : "waters pass side by side";
}

Rgb8 water_band_colour(WaterBand band) {
  // Red, green and blue of Okabe and Ito, which colour-blind people can distinguish.
  return band == WaterBand::none  ? Rgb8{213, 94, 0}
         : band == WaterBand::one ? Rgb8{0, 158, 115}
                                  : Rgb8{0, 114, 178};
}

std::string bottleneck_radius_text(const Channel& channel) {
  return readable_number(fixed_digits(channel.widest_angstrom, 3));
}

std::string passing_waters_text(const FoundChannel& found) {
  if (!found.is_whole())
    return "the channel covers only a part of the molecule, so nothing is said about what passes "
           "the molecule";
  return water_band_text(water_band(found.channel->narrowest().radius_angstrom));
}

std::string cover_text(const WayCover& cover) {
  char text[96];
  std::snprintf(text, sizeof text, "%.1f of %.1f Å of the molecule", cover.covered_angstrom,
                cover.whole_angstrom);
  return text;
}

std::string chains_text(const std::vector<std::string>& chains) {
  std::string text;
  for (const std::string& chain : chains) {
    text += (text.empty() ? "" : ", ") +
            (chain.empty() ? std::string("a chain without a name") : chain);
  }
  return text;
}

std::string pore_contents_text(const WayFacts& way) {
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* some) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + (count == 1 ? one : some);
  };
  add(way.ions, " ion", " ions");
  add(way.ligand_atoms, " atom of ligands", " atoms of ligands");
  add(way.other_atoms, " other atom", " other atoms");
  return text;
}

std::string touching_text(const BallReferences& atoms, const Channel& channel) {
  std::string text;
  for (const BallIndex ball : channel.touching) {
    text += (text.empty() ? "" : ", ") + atom_text(atoms, ball);
  }
  return text;
}

}  // namespace alphascope
