// SPDX-License-Identifier: GPL-3.0-or-later
// Channels as JSON (docs/output-files.md).
#pragma once

#include "core/channel/channel.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/export/record_json.hpp"
#include "core/document/reference/reference.hpp"

namespace alphascope {

// Keys widest_angstrom, step_angstrom, open, limit, bottleneck, length_angstrom, samples.
Json channel_json(const BallReferences& atoms, const Channel& channel);
// The request: kind, point_angstrom, to_angstrom, along, end_radius_angstrom.
Json channel_request_json(const ChannelEnds& ends);
// The same. If the channel is a way through, the request is only the number of that way.
Json channel_request_json(const FoundChannel& found);
// Adds keys way (null if the channel is not one), covered_angstrom, whole_angstrom, is_whole.
void add_cover_json(const FoundChannel& found, Json& json);
// The list of ways: for each the keys of add_cover_json(), its bottleneck and its length.
Json ways_json(const FoundWays& ways);

}  // namespace alphascope
