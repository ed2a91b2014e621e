// SPDX-License-Identifier: GPL-3.0-or-later
// The channel in the view: a tube of spheres along its line, in the colours of the profile's bands.
#include <algorithm>
#include <utility>

#include "core/channel/channel.hpp"
#include "core/document/channels/channel_text.hpp"
#include "ui/layer.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/rgb8.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Where the channel is narrower than this or closed, the tube has this radius.
constexpr double kThinnest = 0.15;  // Å

Colour colour_of(WaterBand band) {
  return to_colour(water_band_colour(band));
}

LayerSphere sphere_of(const ChannelSample& sample) {
  return {sample.position_angstrom, std::max(sample.radius_angstrom, kThinnest),
          colour_of(water_band(sample.radius_angstrom))};
}

std::shared_ptr<Layer> new_layer(const char* id, const ChannelState& memory) {
  static std::uint64_t key = 0;  // each layer gets a new key
  auto layer = std::make_shared<Layer>();
  layer->id = id;
  layer->key = ++key;
  layer->balls = memory.layers_of;
  return layer;
}

void make_layers(ChannelState& memory) {
  const Channel& channel = *memory.shown->channel;
  auto layer = new_layer("channels.tube", memory);
  layer->body = true;  // balls and simplices around it fade
  auto& tube = layer->tubes.emplace_back();
  for (const ChannelSample& sample : channel.samples) tube.push_back(sphere_of(sample));
  const std::string radius = bottleneck_radius_text(channel) + " Å";
  const std::string through = memory.shown->way ? memory.shown->way->through : "";
  layer->name = "Channel" + (through.empty() ? "" : " through " + through) + "  ·  " +
                (channel.is_open() ? "narrowest radius " + radius : "closed");
  layer->page = "channels";
  layer->labels.push_back(
      {channel.narrowest().position_angstrom, channel.is_open() ? radius : "closed here"});
  memory.layers = {std::move(layer)};
}

// Marks the place under the mouse by a ball around the tube. Saved pictures leave it out.
void make_cursor(ChannelState& memory, const Colour& colour) {
  auto layer = new_layer("channels.cursor", memory);
  const auto& samples = memory.shown->channel->samples;
  LayerSphere sphere = sphere_of(samples[static_cast<std::size_t>(memory.cursor)]);
  sphere.radius_angstrom = 1.05 * sphere.radius_angstrom + 0.1;
  sphere.colour = colour;
  layer->spheres.push_back(sphere);
  layer->in_pictures = false;
  memory.cursor_layer = std::move(layer);
}

}  // namespace

void show_channel(PanelContext& ctx, ChannelState& memory) {
  if (!memory.shown || !memory.shown->channel || !ctx.state.shown_balls()) return;
  // Layers are drawn only with the complex of their balls. The tube is the same for each alpha and
  // solvent radius.
  if (memory.layers.empty() || memory.layers_of != ctx.state.shown_balls()) {
    memory.layers_of = ctx.state.shown_balls();
    make_layers(memory);
    memory.cursor_layer = nullptr;
  }
  for (const auto& layer : memory.layers) ctx.state.layers.push_back(layer);
  if (memory.cursor < 0) return;
  if (!memory.cursor_layer) make_cursor(memory, ctx.palette.selected);
  ctx.state.layers.push_back(memory.cursor_layer);
}

}  // namespace alphascope
