// SPDX-License-Identifier: GPL-3.0-or-later
// A channel as records for programs (docs/output-files.md), written by command line and window.
#pragma once

#include "core/document/channels/channel_results.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/store/key.hpp"
#include "core/selection/provenance.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

CsvRow channel_csv_row(const ChannelSample& sample, const RecordSource& source,
                       const Provenance& provenance);

// Key of text on a channel that exists already. It does not depend on the complex on screen.
Key key_of_channel(const FoundChannel& found);

// The samples as CSV, or the whole channel as JSON, both with provenance. Requires found->channel.
Definition<std::string> channel_csv(const std::shared_ptr<const FoundChannel>& found,
                                    const RecordSource& source);
Definition<std::string> channel_as_json(const std::shared_ptr<const FoundChannel>& found,
                                        const RecordSource& source);
std::string channel_csv_text(const Channel& channel, const RecordSource& source);

}  // namespace alphascope
