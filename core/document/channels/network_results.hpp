// SPDX-License-Identifier: GPL-3.0-or-later
// The solvent radius and alpha at which a network of the table on screen falls apart, as a derived
// result.
#pragma once

#include <array>

#include "core/cavity_identity/network_radius.hpp"
#include "core/geometry/ball_index.hpp"

namespace alphascope {

template <class T>
struct Definition;

struct FoundNetworkEnd {
  std::array<BallIndex, 4> sink;  // of the network
  NetworkEnd end;
};
// The end of the network with this deepest sink. Fails if the table has no such cavity. Runs in the
// background; it takes a few triangulations of all balls.
Definition<FoundNetworkEnd> network_end(const std::array<BallIndex, 4>& sink);

}  // namespace alphascope
