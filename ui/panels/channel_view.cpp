// A channel in the view: spheres along its line as a tube in the colours of the profile's bands.
#include <algorithm>
#include <cstdio>
#include <utility>

#include "ui/panels/channel_parts.hpp"

namespace alphascope {
namespace {

// Where the way is narrower, or closed, a thread shows where it goes.
constexpr double kThinnest = 0.15;  // Å

std::uint64_t next_key() {
  static std::uint64_t key = 0;
  return ++key;
}

Colour layer_colour(WaterBand band) {
  const ChartColour c = water_band_colour(band);
  return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255,
          static_cast<float>(c.b) / 255, 1};
}

LayerSphere sphere_of(const ChannelSample& sample) {
  return {sample.position_angstrom, std::max(sample.radius_angstrom, kThinnest)};
}

// Pieces of one band; each begins where the last one ended.
std::vector<std::vector<LayerSphere>> pieces_of(const Channel& channel, WaterBand band) {
  std::vector<std::vector<LayerSphere>> pieces;
  bool going = false;
  for (std::size_t n = 0; n < channel.samples.size(); ++n) {
    const ChannelSample& sample = channel.samples[n];
    const bool on = water_band(sample.radius_angstrom) == band;
    if (on && !going) {
      pieces.emplace_back();
      if (n > 0) pieces.back().push_back(sphere_of(channel.samples[n - 1]));
    }
    if (on) pieces.back().push_back(sphere_of(sample));
    going = on;
  }
  return pieces;
}

void make_layers(ChannelMemory& memory, const std::shared_ptr<const BallSet>& balls) {
  memory.layers.clear();
  memory.layers_of = balls;
  const Channel& channel = *memory.shown->channel;
  for (const WaterBand band : {WaterBand::none, WaterBand::one, WaterBand::several}) {
    auto layer = std::make_shared<Layer>();
    layer->id = "channels.tube." + std::to_string(static_cast<int>(band));
    layer->key = next_key();
    layer->balls = balls;
    layer->tubes = pieces_of(channel, band);
    layer->colour = layer_colour(band);
    if (!layer->tubes.empty()) memory.layers.push_back(std::move(layer));
  }
  auto label = std::make_shared<Layer>();
  label->id = "channels.bottleneck";
  label->key = next_key();
  label->balls = balls;
  char text[32];
  std::snprintf(text, sizeof text, "%.3f Å", channel.narrowest().radius_angstrom);
  label->labels.push_back({channel.narrowest().position_angstrom, text});
  label->colour = layer_colour(water_band(channel.narrowest().radius_angstrom));
  memory.layers.push_back(std::move(label));
}

void make_cursor(ChannelMemory& memory, const Colour& colour) {
  auto layer = std::make_shared<Layer>();
  layer->id = "channels.cursor";
  layer->key = next_key();
  layer->balls = memory.layers_of;
  const auto& samples = memory.shown->channel->samples;
  LayerSphere sphere = sphere_of(samples[static_cast<std::size_t>(memory.cursor)]);
  sphere.radius_angstrom *= 1.02;  // over the tube
  layer->spheres.push_back(sphere);
  layer->colour = colour;
  memory.cursor_layer = std::move(layer);
}

}  // namespace

ChartColour water_band_colour(WaterBand band) {
  // Red, green and blue of Okabe and Ito, told apart by colour-blind people.
  return band == WaterBand::none  ? ChartColour{213, 94, 0}
         : band == WaterBand::one ? ChartColour{0, 158, 115}
                                  : ChartColour{0, 114, 178};
}

void show_channel(PanelContext& ctx) {
  ChannelMemory& memory = ctx.state.memory.channels;
  if (!memory.shown || !memory.shown->channel || !ctx.state.result) return;
  // Layers are drawn with the complex of their balls only. The tube is the same for all of them.
  if (memory.layers.empty() || memory.layers_of != ctx.state.result->balls) {
    make_layers(memory, ctx.state.result->balls);
    memory.cursor_layer = nullptr;
  }
  for (const auto& layer : memory.layers) ctx.state.layers.push_back(layer);
  if (memory.cursor < 0) return;
  if (!memory.cursor_layer) make_cursor(memory, ctx.palette.selected);
  ctx.state.layers.push_back(memory.cursor_layer);
}

}  // namespace alphascope
