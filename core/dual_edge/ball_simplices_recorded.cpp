// SPDX-License-Identifier: GPL-3.0-or-later
// BallSimplices with a sink that records its steps. This is a source of its own so that the
// engine's code stays as it is without a sink.
#include "core/dual_edge/ball_simplices_body.hpp"

namespace alphascope {

VertexState BallSimplices::process(std::uint32_t slot, std::span<const std::uint32_t> list,
                                   BlockOutput& out, const BallSimplicesSink& sink) {
  return process_with(slot, list, out, sink);
}

}  // namespace alphascope
