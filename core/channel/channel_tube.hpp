// The surface of a channel, for programs that draw meshes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/channel/channel.hpp"

namespace alphascope {

// Each triangle is counterclockwise when seen from outside the channel.
struct ChannelTube {
  std::vector<RealPoint> points;       // Å
  std::vector<double> radii_angstrom;  // of each point: that of its sample
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A circle around each sample, normal to the line, of the sample's radius; flat at both ends.
// Closed, but where the line turns within its radius circles cross. Where a channel is closed
// nothing is drawn, so it can be in several pieces, and empty.
ChannelTube channel_tube(const Channel& channel);

}  // namespace alphascope
