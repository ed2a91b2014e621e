// Where a network of the table on screen falls apart, as a derived result.
#pragma once

#include <array>

#include "core/cavity_identity/network_radius.hpp"
#include "core/document/store/definition.hpp"

namespace alphascope {

struct FoundNetworkEnd {
  std::array<BallIndex, 4> sink;  // of the network
  NetworkEnd end;
};
// Of the cavity of this deepest sink, which is a network in the table; else it fails. In the
// background: a few triangulations of all balls.
Definition<FoundNetworkEnd> network_end(const std::array<BallIndex, 4>& sink);

}  // namespace alphascope
