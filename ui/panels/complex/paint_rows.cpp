// SPDX-License-Identifier: GPL-3.0-or-later
// The rows for scheme, colour map, single colour and range.
#include "ui/panels/complex/paint_rows.hpp"

#include <cmath>

#include "core/document/commands/number_input.hpp"
#include "ui/rgb8.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/colour_field.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void scheme_row(PanelContext& ctx, const PaintRows& rows, Paint& paint) {
  const std::string name = rows.name + "_colour";
  row_label(ctx, "Colour by");
  if (!list_field(ctx, name.c_str(), scheme_info(paint.by).title, ImGuiComboFlags_HeightLarge)) {
    return;
  }
  for (const SchemeInfo& scheme : all_schemes()) {
    if (!can_paint(scheme, rows.what)) continue;
    if (ImGui::Selectable(scheme.title, paint.by == scheme.by)) {
      paint = with_scheme(paint, scheme.by);
    }
    record(ctx, (name + "." + std::to_string(static_cast<int>(scheme.by))).c_str());
  }
  ImGui::EndCombo();
}

void map_row(PanelContext& ctx, const PaintRows& rows, Paint& paint) {
  const std::string name = rows.name + "_map";
  const bool quantity = scheme_info(paint.by).quantity;
  row_label(ctx, "Colours");
  ImGui::BeginDisabled(!quantity);
  const ColourMapInfo& used = colour_map_info(paint.map_used());
  if (list_field(ctx, name.c_str(), quantity ? used.title : "of the scheme")) {
    for (const ColourMap map : kColourMaps) {
      const ColourMapInfo& info = colour_map_info(map);
      if (ImGui::Selectable(info.title, paint.map_used() == map)) paint.map = map;
      tooltip(ctx, (std::string(info.help) + ".").c_str());
      record(ctx, (name + "." + info.id).c_str());
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
}

void one_colour_row(PanelContext& ctx, const PaintRows& rows, Paint& paint) {
  const std::string name = rows.name + "_one_colour";
  constexpr float kButton = 64;
  row_label(ctx, "Colour", kButton + 6);
  Colour shown = to_colour(paint.colour.value_or(rows.usual));
  if (colour_field(ctx, name, shown)) paint.colour = to_rgb8(shown);
  tooltip(ctx, "Click on the patch to choose, or type hexadecimal digits.");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::BeginDisabled(!paint.colour);
  if (button(ctx, (name + ".usual").c_str(), "Usual", {ctx.px(kButton), 0})) paint.colour.reset();
  ImGui::EndDisabled();
}

// Draws the range. A typed end replaces the automatic range, and no end can pass the other.
void range_row(PanelContext& ctx, const PaintRows& rows, Paint& paint) {
  const SchemeInfo& scheme = scheme_info(paint.by);
  const std::string name = rows.name + "_range";
  row_label(ctx, scheme.quantity ? (std::string("Range, ") + scheme.unit).c_str() : "Range");
  constexpr float kButton = 44, kTo = 22;
  const float gap = ctx.px(4);
  const float each =
      (ImGui::GetContentRegionAvail().x - ctx.px(kButton) - ctx.px(kTo) - 2 * gap) / 2;
  ColourRange range = paint.range.value_or(rows.drawn.value_or(ColourRange{0, 100}));
  if (!paint.range) {  // values such as the least alpha value have many digits
    const auto rounded = [](double x) { return std::round(x * 1000) / 1000; };
    range = {rounded(range.low), rounded(range.high)};
  }
  const ColourRange before = range;
  const NumberRule rule = range_rule(scheme);
  ImGui::BeginDisabled(!scheme.quantity || (!rows.drawn && !paint.range));
  ImGui::SetNextItemWidth(each);
  number_field(ctx, (name + ".low").c_str(), range.low,
               {rule.name, rule.least, range.high, rule.unit});
  ImGui::SameLine(0, gap);
  ImGui::TextUnformatted("to");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(each);
  number_field(ctx, (name + ".high").c_str(), range.high,
               {rule.name, range.low, rule.most, rule.unit});
  ImGui::SameLine(0, gap);
  if (range != before && range.low < range.high) paint.range = range;
  ImGui::BeginDisabled(!paint.range);
  if (button(ctx, (name + ".auto").c_str(), "Auto", {ctx.px(kButton), 0})) paint.range.reset();
  tooltip(ctx, "Uses the range of the present values.");
  ImGui::EndDisabled();
  ImGui::EndDisabled();
}

}  // namespace

void paint_rows(PanelContext& ctx, const PaintRows& rows, Paint& paint) {
  scheme_row(ctx, rows, paint);
  if (paint.by == ColourBy::single) {
    one_colour_row(ctx, rows, paint);
  } else {
    map_row(ctx, rows, paint);
  }
  range_row(ctx, rows, paint);
}

}  // namespace alphascope
