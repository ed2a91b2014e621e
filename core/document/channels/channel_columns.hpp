// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a channel's samples, and of the ways through a molecule.
#pragma once

#include <span>
#include <string>

namespace alphascope {

template <class Row>
struct Column;
struct Channel;
struct ChannelSample;
struct FoundChannel;

// In the order of the CSV. The provenance follows there.
std::span<const Column<ChannelSample>> sample_columns();

// The channels must be ways: FoundChannel::way is set.
std::span<const Column<FoundChannel>> way_columns();

// The bottleneck's place: "1.2, −3.4, 5.6", in Å.
std::string bottleneck_place(const Channel& channel);

}  // namespace alphascope
