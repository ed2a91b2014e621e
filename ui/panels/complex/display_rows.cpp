// SPDX-License-Identifier: GPL-3.0-or-later
// Draws check boxes and sliders of settings of the display.
#include "ui/panels/complex/display_rows.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "ui/layer.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// The value beside the slider: "1.50 px".
std::string shown_value(const DisplayField& field, double value) {
  if (field.rule.whole) return number_text(value, 0);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(field.step))));
  const std::string_view unit = field.rule.unit;
  return number_text(value, decimals) + " " + std::string(unit == "pixels" ? "px" : unit);
}

void percent_of(PanelContext& ctx, const DisplayField& field, const char* name) {
  DisplaySettings& d = ctx.state.settings.display;
  auto share = static_cast<float>(number_of(field, d));
  if (percent_slider(ctx, name, share, static_cast<float>(field.rule.least),
                     static_cast<float>(field.rule.most))) {
    set_number(field, d, static_cast<double>(share));
  }
}

}  // namespace

double shown_opacity(const PanelContext& ctx, double set) {
  return ctx.state.viewport.fades_rest ? std::min(set, kFadedOpacity) : set;
}

void fading_note(PanelContext& ctx, const std::string& name) {
  ImGui::PushFont(ctx.fonts.small);
  muted_text(ctx, "faded to " + percent_text(kFadedOpacity) + " by the page below");
  ImGui::PopFont();
  record(ctx, name.c_str());
  tooltip(ctx,
          "Balls, simplices and objects are faded, so that they do not hide a cavity or channel. "
          "For cavities: the page Cavities, Draw, “fade the rest”.");
}

std::string control_name(const DisplayField& field) {
  return (field.group == DisplayGroup::light ? "look." : "display.") + std::string(field.id);
}

void display_slider(PanelContext& ctx, const DisplayField& field, const char* name) {
  DisplaySettings& d = ctx.state.settings.display;
  if (field.percent) {
    percent_of(ctx, field, name);
  } else {
    double value = number_of(field, d);
    const double most = field.slider_most > 0 ? field.slider_most : field.rule.most;
    if (value_slider(ctx, name, value, field.rule.least, most, field.rule,
                     shown_value(field, value))) {
      const double steps = std::round(1 / field.step);  // exact, where the step may not be
      set_number(field, d, std::round(value * steps) / steps);
    }
  }
  tooltip(ctx, (std::string(field.help) + ".").c_str());
}

void display_row(PanelContext& ctx, const DisplayField& field) {
  const std::string name = control_name(field);
  if (is_number(field)) {
    row_label(ctx, field.label);
    return display_slider(ctx, field, name.c_str());
  }
  DisplaySettings& d = ctx.state.settings.display;
  checkbox(ctx, name.c_str(), field.label, d.*std::get<bool DisplaySettings::*>(field.member));
  tooltip(ctx, (std::string(field.help) + ".").c_str());
}

void display_row(PanelContext& ctx, DisplayField::Member member) {
  display_row(ctx, display_field(member));
}

}  // namespace alphascope
