// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of channels share.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/channel/channel_ends.hpp"
#include "core/document/store/definition.hpp"

namespace alphascope {

struct Channel;
struct ChannelState;
struct FoundChannel;
struct FoundWays;
struct PanelContext;
struct Plot;

// The ends of a channel as the user set them. Without ends, `why` gives the reason and the remedy.
struct ChannelRequest {
  std::optional<ChannelEnds> ends;
  std::string why;
  bool waiting = false;       // a result that is needed is being computed
  bool wants_cavity = false;  // the user has to choose a cavity on its page
};
ChannelRequest channel_request(PanelContext& ctx, ChannelState& memory);
// Draws the two rows that choose both ends.
void draw_channel_ends(PanelContext& ctx, ChannelState& memory);
// To be called before all else in each frame: follows the molecule and its balls. Returns false
// while there are none.
bool follow_molecule_of_channels(PanelContext& ctx, ChannelState& memory);
// Asks for the ways through the molecule.
Derived<FoundWays> want_ways(PanelContext& ctx, const ChannelState& memory);
// Makes this the shown channel.
void take_found_channel(const PanelContext& ctx, ChannelState& memory,
                        const std::shared_ptr<const FoundChannel>& found);
// Draws a line for each way through the molecule. A click chooses the way.
void draw_ways(PanelContext& ctx, ChannelState& memory, const FoundWays& ways);

// Draws the radius of the bottleneck beside the names of the pages.
void channel_headline(PanelContext& ctx, const FoundChannel& found);
// Draws ChannelState::shown in words. `current`: it answers the present question.
void draw_found_channel(PanelContext& ctx, const ChannelState& memory, bool current);
// Says why there is no channel.
void channel_problem(PanelContext& ctx, const std::string& text);
// Draws buttons that copy the profile and save the channel. Requires found->channel.
void channel_save_buttons(PanelContext& ctx, const std::shared_ptr<const FoundChannel>& found);

// Looks across the whole line, and zooms out if it does not fit around the view's middle.
void look_across_line(PanelContext& ctx, const Channel& channel);
// Selects the atoms at the bottleneck and looks at it. ChannelState::shown must have a channel.
void select_bottleneck(PanelContext& ctx, const ChannelState& memory);

// Radius against length, with the limits of HOLE's colours.
Plot profile_plot(const Channel& channel);
// Draws radius against length in the remaining room, and sets the cursor.
void draw_channel_profile(PanelContext& ctx, ChannelState& memory, const Channel& channel);

// Draws the tube, the bottleneck's label and the place under the cursor as layers of the view.
void show_channel(PanelContext& ctx, ChannelState& memory);

}  // namespace alphascope
