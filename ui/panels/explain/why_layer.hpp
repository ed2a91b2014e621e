// What is drawn of an explanation. No ImGui.
#pragma once

#include <cstdint>
#include <memory>

#include "core/explain/explanation.hpp"
#include "ui/layer.hpp"

namespace alphascope {

// The orthosphere as a ball of wire, where it is not imaginary; its centre; the nearest other ball
// and the distance to it; the dual edge, the edges of the dual facet or those of the power cell.
std::shared_ptr<const Layer> make_why_layer(const Explanation& e,
                                            const std::shared_ptr<const BallSet>& balls,
                                            std::uint64_t key);

}  // namespace alphascope
