// The parts of the page of channels.
#pragma once

#include <optional>
#include <string>

#include "core/document/channels/channel_texts.hpp"
#include "ui/panels/channels/channel_memory.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// From where to where, as it is set; or why there is no such channel yet, with the remedy.
struct ChannelQuestion {
  std::optional<ChannelEnds> ends;
  std::string why;
  bool waiting = false;       // for something that is computed
  bool wants_cavity = false;  // one has to be chosen on its page
};
ChannelQuestion channel_question(PanelContext& ctx, ChannelMemory& memory);
// Two rows: from where, to where.
void draw_channel_ends(PanelContext& ctx, ChannelMemory& memory);
// A line for each way through the molecule; a click takes it.
void draw_ways(PanelContext& ctx, ChannelMemory& memory, const FoundWays& ways);

// Radius against length, in the room that is left; sets the cursor.
void draw_channel_profile(PanelContext& ctx, ChannelMemory& memory, const Channel& channel);

// The tube, the bottleneck's label and the place under the cursor, as layers of the view.
void show_channel(PanelContext& ctx, ChannelMemory& memory);

}  // namespace alphascope
