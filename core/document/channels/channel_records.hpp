// A channel as programs read it (docs/output-files.md): what the command line and the window write
// of it.
#pragma once

#include "core/document/channels/channel_results.hpp"
#include "core/document/export/record_source.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

CsvRow channel_csv_row(const ChannelSample& sample, const RecordSource& source,
                       const Provenance& provenance);

// Of what is written of a channel that is there already: it depends on nothing on screen.
Key key_of_channel(const FoundChannel& found);

// The samples as CSV, and all of it as JSON, each with where it comes from. `found` has a channel.
Definition<std::string> channel_csv(const std::shared_ptr<const FoundChannel>& found,
                                    const RecordSource& source);
Definition<std::string> channel_as_json(const std::shared_ptr<const FoundChannel>& found,
                                        const RecordSource& source);
std::string channel_csv_text(const Channel& channel, const RecordSource& source);

}  // namespace alphascope
