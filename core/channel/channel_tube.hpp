// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a channel as triangles, for programs that draw meshes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/channel/channel.hpp"

namespace alphascope {

// Each triangle is counterclockwise when seen from outside the channel.
struct ChannelTube {
  std::vector<RealPoint> points;       // Å
  std::vector<double> radii_angstrom;  // for each point the radius of its sample
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Puts a circle of the sample's radius around each sample, normal to the line, and closes both ends
// flat. The surface is closed, but circles cross where the line turns within its radius. Parts with
// a radius of at most 0 are left out. So the tube can be empty or have several pieces.
ChannelTube channel_tube(const Channel& channel);

}  // namespace alphascope
