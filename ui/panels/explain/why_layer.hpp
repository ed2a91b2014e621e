// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of an explanation as a layer of the view. No ImGui.
#pragma once

#include <cstdint>
#include <memory>

#include "ui/layer.hpp"

namespace alphascope {

struct Explanation;

// Draws the orthosphere as wire if it is not imaginary, and its centre. It draws the nearest other
// ball and the distance to it. It also draws the dual edge, or the edges of the dual facet or of
// the power cell.
std::shared_ptr<const Layer> make_why_layer(const Explanation& e,
                                            const std::shared_ptr<const BallSet>& balls,
                                            std::uint64_t key);

}  // namespace alphascope
