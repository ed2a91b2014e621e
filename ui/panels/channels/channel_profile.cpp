// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of a channel's radius against the length of its line.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/channel/channel.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

ImU32 band_colour(WaterBand band) {
  const Rgb8 c = water_band_colour(band);
  return IM_COL32(c.r, c.g, c.b, 255);
}

// Adds the limits of HOLE's colours as areas behind the curve.
void add_bands(Plot& plot) {
  const PlotRange& radius = plot.y.range;
  const double limits[] = {radius.low, kOneWaterAngstrom, kTwoWatersAngstrom, radius.high};
  const WaterBand bands[] = {WaterBand::none, WaterBand::one, WaterBand::several};
  for (std::size_t n = 0; n < std::size(bands); ++n) {
    const double low = std::clamp(limits[n], radius.low, radius.high);
    const double high = std::clamp(limits[n + 1], radius.low, radius.high);
    if (low >= high) continue;
    plot.boxes.push_back({plot.x.range.low,
                          plot.x.range.high,
                          low,
                          high,
                          {ChartColourRole::text, water_band_colour(bands[n]), 0.13f}});
  }
}

// The meaning of the colours, at the right of "radius". Less room makes it shorter.
struct LegendEntry {
  WaterBand band;
  std::string text;
};
using Legend = std::vector<LegendEntry>;

Legend legend_of(bool in_words) {
  const std::string one = number_text(kOneWaterAngstrom, 2),
                    two = number_text(kTwoWatersAngstrom, 2);
  return {{WaterBand::none, "below " + one + (in_words ? ": no water" : "")},
          {WaterBand::one, "to " + two + (in_words ? ": one water" : "")},
          {WaterBand::several, "wider"}};
}

float legend_width(const Legend& legend, float side, float gap) {
  float width = -gap;
  for (const LegendEntry& e : legend) {
    width += 1.5f * side + ImGui::CalcTextSize(e.text.c_str()).x + gap;
  }
  return width;
}

void draw_legend(PanelContext& ctx, const PlotArea& area) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float side = ctx.px(9), gap = ctx.px(14);
  const float room = area.width() - ImGui::CalcTextSize("radius (Å)").x - gap;
  Legend legend = legend_of(true);
  if (legend_width(legend, side, gap) > room) legend = legend_of(false);
  const float width = legend_width(legend, side, gap);
  if (width > room) return;
  const ImVec2 corner{area.right - width, area.top - ImGui::GetTextLineHeight() - ctx.px(3)};
  float x = corner.x;
  for (const LegendEntry& e : legend) {
    const float top = corner.y + (ImGui::GetTextLineHeight() - side) / 2;
    draw->AddRectFilled({x, top}, {x + side, top + side}, band_colour(e.band));
    x += 1.5f * side;
    draw->AddText({x, corner.y}, to_u32(ctx.palette.text_muted), e.text.c_str());
    x += ImGui::CalcTextSize(e.text.c_str()).x + gap;
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("##legend", {width, ImGui::GetTextLineHeight()});
  record(ctx, "channels.legend");
  tooltip(
      ctx,
      "The limits of HOLE's colours, in Å: no water passes, one water at a time, or waters side "
      "by side (Smart et al., 1996).");
}

// Writes the radius of the bottleneck at the right of its line, or at its left where room is short.
void draw_bottleneck(PanelContext& ctx, const PlotArea& area, const Channel& channel) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ChannelSample& narrowest = channel.narrowest();
  const ImVec2 at{area.x_of(narrowest.along_angstrom), area.y_of(narrowest.radius_angstrom)};
  const std::string text = bottleneck_radius_text(channel) + " Å";
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float right = at.x + ctx.px(7) + size.x;
  const float x = right < area.right ? at.x + ctx.px(7) : at.x - ctx.px(7) - size.x;
  const float y = std::min(at.y + ctx.px(2), area.bottom - size.y - ctx.px(1));
  draw->AddRectFilled({x - ctx.px(2), y}, {x + size.x + ctx.px(2), y + size.y},
                      to_u32(ctx.palette.panel, 0.8f));
  draw->AddText({x, y}, to_u32(ctx.palette.text), text.c_str());
}

// Shows the value under the mouse, here and in the view.
void take_mouse(PanelContext& ctx, ChannelState& memory, const Plot& plot, const PlotArea& area,
                const Channel& channel) {
  const int before = memory.cursor;
  const PlotMouse mouse = plot_mouse(ctx, area, "channels.profile");
  const auto sample = nearest_point(plot.curves.front(), mouse.x);
  memory.cursor = mouse.hovered && sample ? static_cast<int>(*sample) : -1;
  if (memory.cursor != before) memory.cursor_layer = nullptr;
  if (memory.cursor < 0) return;
  const ChannelSample& s = channel.samples[static_cast<std::size_t>(memory.cursor)];
  draw_cursor(ctx, plot, area, s.along_angstrom);
  const RealPoint& p = s.position_angstrom;
  const std::string text = "at " + number_text(s.along_angstrom, 1) + " Å: radius " +
                           number_text(s.radius_angstrom, 2) + " Å, place " + number_text(p.x, 1) +
                           ", " + number_text(p.y, 1) + ", " + number_text(p.z, 1);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float left = area.left + ctx.px(3);
  const float x = std::clamp(area.x_of(s.along_angstrom) - size.x / 2, left,
                             std::max(left, area.right - size.x - ctx.px(3)));
  const float y = area.top + ctx.px(2);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({x - ctx.px(3), y}, {x + size.x + ctx.px(3), y + size.y},
                      to_u32(ctx.palette.panel_raised));
  draw->AddText({x, y}, to_u32(ctx.palette.text), text.c_str());
}

}  // namespace

Plot profile_plot(const Channel& channel) {
  Plot plot;
  plot.value_label = PlotLabel::above;
  plot.x = {.range = {0, std::max(channel.length_angstrom, 1e-6)},
            .label = "length along the channel (Å)"};
  plot.y = {.range = {0, 2.5}, .label = "radius (Å)"};
  PlotCurve curve{.paint = plot_ink(ChartColourRole::text)};
  for (const ChannelSample& sample : channel.samples) {
    plot.y.range.take(sample.radius_angstrom);
    plot.y.range.take(1.05 * sample.radius_angstrom);
    curve.points.push_back({sample.along_angstrom, sample.radius_angstrom});
  }
  add_bands(plot);
  plot.curves.push_back(std::move(curve));
  const ChannelSample& narrowest = channel.narrowest();
  plot.lines.push_back({narrowest.along_angstrom, plot_ink(ChartColourRole::accent, 0.6f)});
  plot.dots.push_back(
      {narrowest.along_angstrom, narrowest.radius_angstrom, plot_ink(ChartColourRole::accent), 4});
  return plot;
}

void draw_channel_profile(PanelContext& ctx, ChannelState& memory, const Channel& channel) {
  ImGui::PushFont(ctx.fonts.small);
  auto area = plot_area(ctx, {.left = 34,
                              .top = 3,
                              .right = 14,
                              .bottom = 10,
                              .lines_above = 1,
                              .least_width = 80,
                              .least_height = 24});
  if (area) {
    const Plot plot = profile_plot(channel);
    draw_plot(ctx, plot, *area);
    draw_legend(ctx, *area);
    draw_bottleneck(ctx, *area, channel);
    take_mouse(ctx, memory, plot, *area, channel);
  }
  ImGui::PopFont();
}

}  // namespace alphascope
