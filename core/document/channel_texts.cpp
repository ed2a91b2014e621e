// See the header.
#include "core/document/channel_texts.hpp"

#include "core/molecule/atom_address.hpp"

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

std::string atom_text(const BallReferences& atoms, BallIndex ball) {
  return atom_address(atoms.molecule(), atoms.prepared().atom_of_ball.at(ball));
}

std::string touching_text(const BallReferences& atoms, const Channel& channel) {
  std::string text;
  for (const BallIndex ball : channel.touching) {
    text += (text.empty() ? "" : ", ") + atom_text(atoms, ball);
  }
  return text;
}

}  // namespace alphascope
