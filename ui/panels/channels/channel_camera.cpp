// SPDX-License-Identifier: GPL-3.0-or-later
// Views of a channel from the side: of its bottleneck, and of the whole line.
#include <algorithm>
#include <utility>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/reference/reference.hpp"
#include "ui/calls.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Turns the view across the line from one sample to another.
void look_across(PanelContext& ctx, const Channel& channel, std::size_t from, std::size_t to) {
  const RealPoint line =
      channel.samples[to].position_angstrom - channel.samples[from].position_angstrom;
  if (line != RealPoint{}) ctx.calls.view.look_across(unit_vector(line));
}

// Looks at the bottleneck across the channel. Seen from an end, outer atoms would hide it.
void look_across_bottleneck(PanelContext& ctx, const Channel& channel) {
  constexpr std::size_t kNear = 20;  // samples
  const std::size_t at = channel.bottleneck, last = channel.samples.size() - 1;
  look_across(ctx, channel, at - std::min(at, kNear), std::min(at + kNear, last));
}

}  // namespace

// Looks across the whole line, and zooms out if it does not fit around the view's middle.
void look_across_line(PanelContext& ctx, const Channel& channel) {
  const ChannelSample &begin = channel.samples.front(), &end = channel.samples.back();
  look_across(ctx, channel, 0, channel.samples.size() - 1);
  constexpr double kMargin = 1.15;
  const double tall = length(end.position_angstrom - begin.position_angstrom) +
                      begin.radius_angstrom + end.radius_angstrom;
  const ViewportInfo& view = ctx.state.viewport;
  const double room = std::min(view.width, view.height) * view.angstrom_per_pixel;
  if (room > 0 && room < kMargin * tall) ctx.calls.view.zoom(room / (kMargin * tall));
}

void select_bottleneck(PanelContext& ctx, const ChannelState& memory) {
  std::vector<Ref> refs;
  for (const BallIndex ball : memory.shown->channel->touching) {
    refs.push_back(ctx.state.references->atom(ball));
  }
  ctx.state.settings.selection.items = RefSet(std::move(refs));
  ctx.calls.view.zoom_to_selection();
  look_across_bottleneck(ctx, *memory.shown->channel);
}

}  // namespace alphascope
