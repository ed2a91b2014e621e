// Channels as JSON (docs/output-files.md).
#pragma once

#include "core/cavity/channel.hpp"
#include "core/document/record_json.hpp"
#include "core/document/reference.hpp"

namespace alphascope {

// Keys widest_angstrom, step_angstrom, open, limit, bottleneck, length_angstrom, samples.
Json channel_json(const BallReferences& atoms, const Channel& channel);
// What was asked: kind, point_angstrom, to_angstrom, along, end_radius_angstrom.
Json channel_request_json(const ChannelEnds& ends);

}  // namespace alphascope
