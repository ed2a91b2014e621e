// The plot of a channel's radius against the length of its line.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "ui/panels/channels/channel_parts.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

struct Plot {
  ImVec2 from, to;  // pixels: the top left and bottom right corner
  double length, low, high;

  float x(double along) const {
    return from.x + static_cast<float>(along / length) * (to.x - from.x);
  }
  float y(double radius) const {
    const double share = (std::clamp(radius, low, high) - low) / (high - low);
    return to.y - static_cast<float>(share) * (to.y - from.y);
  }
  double along_at(float pixel) const {
    return length * static_cast<double>((pixel - from.x) / (to.x - from.x));
  }
};

// Returns 1, 2 or 5 times a power of ten, so that about `most` ticks fit.
double tick_step(double range, double most) {
  const double least = range / std::max(1.0, most);
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}
int tick_digits(double step) {
  return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}

ImU32 band_colour(WaterBand band, int alpha) {
  const ChartColour c = water_band_colour(band);
  return IM_COL32(c.r, c.g, c.b, alpha);
}

// Draws the limits of HOLE's colours as areas behind the curve.
void draw_bands(const Plot& plot) {
  const double limits[] = {plot.low, kOneWaterAngstrom, kTwoWatersAngstrom, plot.high};
  const WaterBand bands[] = {WaterBand::none, WaterBand::one, WaterBand::several};
  for (std::size_t n = 0; n < 3; ++n) {
    const float top = plot.y(limits[n + 1]), bottom = plot.y(limits[n]);
    if (top >= bottom) continue;
    ImGui::GetWindowDrawList()->AddRectFilled({plot.from.x, top}, {plot.to.x, bottom},
                                              band_colour(bands[n], 34));
  }
}

void draw_axes(PanelContext& ctx, const Plot& plot) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 muted = to_u32(ctx.palette.text_muted), line = to_u32(ctx.palette.border);
  draw->AddRect(plot.from, plot.to, line);
  const float height = ImGui::GetTextLineHeight();
  const double step_y = tick_step(plot.high - plot.low,
                                  static_cast<double>((plot.to.y - plot.from.y) / (2 * height)));
  const auto ticks = [](double low, double high, double step, const auto& use) {
    const long first = std::lround(std::ceil(low / step - 1e-9));
    const long last = std::lround(std::floor(high / step + 1e-9));
    for (long n = first; n <= last; ++n) {
      use(static_cast<double>(n) * step);
    }
  };
  ticks(plot.low, plot.high, step_y, [&](double value) {
    const std::string text = number_text(value, tick_digits(step_y));
    const float y = plot.y(value), width = ImGui::CalcTextSize(text.c_str()).x;
    draw->AddLine({plot.from.x, y}, {plot.to.x, y}, line);
    draw->AddText({plot.from.x - ctx.px(6) - width, y - height / 2}, muted, text.c_str());
  });
  const double step_x =
      tick_step(plot.length, static_cast<double>((plot.to.x - plot.from.x) / ctx.px(60)));
  ticks(0, plot.length, step_x, [&](double value) {
    const std::string text = number_text(value, tick_digits(step_x));
    const float x = plot.x(value), width = ImGui::CalcTextSize(text.c_str()).x;
    draw->AddLine({x, plot.to.y}, {x, plot.to.y + ctx.px(3)}, muted);
    draw->AddText({x - width / 2, plot.to.y + ctx.px(4)}, muted, text.c_str());
  });
}

void draw_titles(PanelContext& ctx, const Plot& plot) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 muted = to_u32(ctx.palette.text_muted);
  draw->AddText({plot.from.x, plot.from.y - ImGui::GetTextLineHeight() - ctx.px(3)}, muted,
                "radius (Å)");
  const char* const kAlong = "length along the channel (Å)";
  const float width = ImGui::CalcTextSize(kAlong).x;
  draw->AddText(
      {(plot.from.x + plot.to.x - width) / 2, plot.to.y + ctx.px(5) + ImGui::GetTextLineHeight()},
      muted, kAlong);
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

void draw_legend(PanelContext& ctx, const Plot& plot) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float side = ctx.px(9), gap = ctx.px(14);
  const float room = plot.to.x - plot.from.x - ImGui::CalcTextSize("radius (Å)").x - gap;
  Legend legend = legend_of(true);
  if (legend_width(legend, side, gap) > room) legend = legend_of(false);
  const float width = legend_width(legend, side, gap);
  if (width > room) return;
  const ImVec2 corner{plot.to.x - width, plot.from.y - ImGui::GetTextLineHeight() - ctx.px(3)};
  float x = corner.x;
  for (const LegendEntry& e : legend) {
    const float top = corner.y + (ImGui::GetTextLineHeight() - side) / 2;
    draw->AddRectFilled({x, top}, {x + side, top + side}, band_colour(e.band, 255));
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

void draw_curve(PanelContext& ctx, const Plot& plot, const Channel& channel) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto place = [&](const ChannelSample& s) {
    return ImVec2{plot.x(s.along_angstrom), plot.y(s.radius_angstrom)};
  };
  std::vector<ImVec2> points;
  for (const ChannelSample& sample : channel.samples) points.push_back(place(sample));
  draw->AddPolyline(points.data(), static_cast<int>(points.size()), to_u32(ctx.palette.text), 0,
                    ctx.px(1.8f));
  // The bottleneck has a line, a dot and its radius. The radius is at the right of the line, or at
  // its left where room is short.
  const ImVec2 at = place(channel.narrowest());
  draw->AddLine({at.x, plot.from.y}, {at.x, plot.to.y}, to_u32(ctx.palette.accent, 0.6f));
  draw->AddCircleFilled(at, ctx.px(4), to_u32(ctx.palette.accent));
  const std::string text = number_text(channel.narrowest().radius_angstrom, 3) + " Å";
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float right = at.x + ctx.px(7) + size.x;
  const float x = right < plot.to.x ? at.x + ctx.px(7) : at.x - ctx.px(7) - size.x;
  const float y = std::min(at.y + ctx.px(2), plot.to.y - size.y - ctx.px(1));
  draw->AddRectFilled({x - ctx.px(2), y}, {x + size.x + ctx.px(2), y + size.y},
                      to_u32(ctx.palette.panel, 0.8f));
  draw->AddText({x, y}, to_u32(ctx.palette.text), text.c_str());
}

int sample_at(const Channel& channel, double along) {
  const auto& samples = channel.samples;
  const auto after =
      std::lower_bound(samples.begin(), samples.end(), along,
                       [](const ChannelSample& s, double at) { return s.along_angstrom < at; });
  auto n = static_cast<int>(after - samples.begin());
  if (n == static_cast<int>(samples.size())) return n - 1;
  if (n > 0 && along - samples[static_cast<std::size_t>(n) - 1].along_angstrom <
                   after->along_angstrom - along) {
    --n;
  }
  return n;
}

// Shows the value under the mouse, here and in the view.
void draw_cursor(PanelContext& ctx, ChannelMemory& memory, const Plot& plot,
                 const Channel& channel) {
  const int before = memory.cursor;
  memory.cursor =
      ImGui::IsItemHovered() ? sample_at(channel, plot.along_at(ImGui::GetIO().MousePos.x)) : -1;
  if (memory.cursor != before) memory.cursor_layer = nullptr;
  if (memory.cursor < 0) return;
  const ChannelSample& s = channel.samples[static_cast<std::size_t>(memory.cursor)];
  const ImVec2 at{plot.x(s.along_angstrom), plot.y(s.radius_angstrom)};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddLine({at.x, plot.from.y}, {at.x, plot.to.y}, to_u32(ctx.palette.text_muted));
  draw->AddCircleFilled(at, ctx.px(3), to_u32(ctx.palette.text));
  const RealPoint& p = s.position_angstrom;
  const std::string text = "at " + number_text(s.along_angstrom, 1) + " Å: radius " +
                           number_text(s.radius_angstrom, 2) + " Å, place " + number_text(p.x, 1) +
                           ", " + number_text(p.y, 1) + ", " + number_text(p.z, 1);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float x = std::clamp(at.x - size.x / 2, plot.from.x + ctx.px(3),
                             std::max(plot.from.x + ctx.px(3), plot.to.x - size.x - ctx.px(3)));
  const float y = plot.from.y + ctx.px(2);
  draw->AddRectFilled({x - ctx.px(3), y}, {x + size.x + ctx.px(3), y + size.y},
                      to_u32(ctx.palette.panel_raised));
  draw->AddText({x, y}, to_u32(ctx.palette.text), text.c_str());
}

}  // namespace

void draw_channel_profile(PanelContext& ctx, ChannelMemory& memory, const Channel& channel) {
  ImGui::PushFont(ctx.fonts.small);
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float line = ImGui::GetTextLineHeight();
  double high = 2.5, low = 0;
  for (const ChannelSample& s : channel.samples) {
    high = std::max(high, 1.05 * s.radius_angstrom);
    low = std::min(low, s.radius_angstrom);
  }
  const Plot plot{{corner.x + ctx.px(34), corner.y + line + ctx.px(3)},
                  {corner.x + room.x - ctx.px(14), corner.y + room.y - 2 * line - ctx.px(10)},
                  std::max(channel.length_angstrom, 1e-6),
                  low,
                  high};
  if (plot.to.x - plot.from.x > ctx.px(80) && plot.to.y - plot.from.y > ctx.px(24)) {
    draw_bands(plot);
    draw_axes(ctx, plot);
    draw_titles(ctx, plot);
    draw_legend(ctx, plot);
    draw_curve(ctx, plot, channel);
    ImGui::SetCursorScreenPos(plot.from);
    ImGui::InvisibleButton("##profile", {plot.to.x - plot.from.x, plot.to.y - plot.from.y});
    record(ctx, "channels.profile");
    draw_cursor(ctx, memory, plot, channel);
  }
  ImGui::PopFont();
}

}  // namespace alphascope
