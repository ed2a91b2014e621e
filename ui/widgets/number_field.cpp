// SPDX-License-Identifier: GPL-3.0-or-later
// Fields and sliders for numbers: typing, refusal of invalid input, and the reason below the field.
#include "ui/widgets/number_field.hpp"

#include <imgui.h>
// Needs imgui.h first.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/chart/colour_scale.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/shortest_number.hpp"
#include "ui/calls.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/number_typing.hpp"

namespace alphascope {
namespace {

// Shows the reason over the widgets below, so that nothing moves.
void reason(PanelContext& ctx, const char* name, const std::string& text) {
  const WidgetRect field = ctx.rects[name];
  ctx.state.number.reason_frame = ImGui::GetFrameCount();
  ctx.state.number.reason_x = field.x0;
  ctx.state.number.reason_y = field.y0;
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoInputs |
                                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize;
  ImGui::SetNextWindowPos({field.x0, field.y1 + ctx.px(3)});
  ImGui::Begin("##number_reason", nullptr, kFlags);
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ctx.px(280));  // for text without blanks
  ImGui::TextUnformatted(broken_lines(text, ctx.px(280)).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  record(ctx, (std::string(name) + ".error").c_str());
  ImGui::End();
}

RefusedNumber* refused_in(PanelContext& ctx, const std::string& name) {
  auto& all = ctx.state.number.refused;
  const auto at = all.find(name);
  if (at == all.end()) return nullptr;
  if (at->second.frame + 1 < ImGui::GetFrameCount()) {  // the field was not drawn in the last frame
    all.erase(at);
    return nullptr;
  }
  at->second.frame = ImGui::GetFrameCount();
  return &at->second;
}

// Draws the text field. Returns true when typing has ended.
bool type(PanelContext& ctx, const char* name, const std::string& shown, std::string& text) {
  NumberTyping& typing = ctx.state.number;
  const bool mine = typing.name == name;
  const RefusedNumber* const refused = mine ? nullptr : refused_in(ctx, name);
  text = mine ? typing.text : refused != nullptr ? refused->text : shown;
  if (mine && std::exchange(typing.focus, false)) ImGui::SetKeyboardFocusHere();
  if (refused != nullptr) {
    ImGui::PushStyleColor(ImGuiCol_Border, to_imgui(ctx.palette.error));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, ctx.px(1));
  }
  ImGui::PushID(name);
  ImGui::InputText("##number", &text, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopID();
  if (refused != nullptr) {
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
  }
  record(ctx, name);
  key_stop(ctx, name, KeyStop::type_when_asked);
  note_enter(ctx, name);
  if (ImGui::IsItemActivated()) {
    typing.refused.erase(name);
    typing.name = name;
  }
  if (typing.name == name) typing.text = text;
  return ImGui::IsItemDeactivated();
}

// A click elsewhere hides the reason, which covers widgets below. On a page, that click or Escape
// also discards the typed text. In a dialog the text stays, because the Confirm button uses the
// texts in the fields.
void tell_reason(PanelContext& ctx, const char* name, RefusedNumber& refused) {
  const bool over = ImGui::IsItemHovered(), elsewhere = !over && ImGui::IsMouseClicked(0);
  const bool escaped = !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key::kEscape, false);
  if (ctx.level == 0 && (elsewhere || escaped)) return forget_typing(ctx, name);
  if (elsewhere) refused.told = false;
  if (refused.told || over) reason(ctx, name, refused.error);
}

// `read` converts the text to a value, or gives the reason why it cannot.
template <class Number, class Read>
bool field(PanelContext& ctx, const char* name, Number& value, const Read& read) {
  NumberTyping& typing = ctx.state.number;
  const std::string shown = shortest_number(value);
  if (const auto* refused = refused_in(ctx, name); refused != nullptr && refused->value != shown) {
    typing.refused.erase(name);
  }
  std::string text;
  const bool over = type(ctx, name, shown, text);
  if (!over) {
    RefusedNumber* const refused = refused_in(ctx, name);
    if (refused != nullptr) tell_reason(ctx, name, *refused);
    return false;
  }
  if (typing.name == name) {
    typing.name.clear();
    typing.text.clear();
  }
  if (text == shown || ImGui::IsKeyPressed(key::kEscape, false)) return false;
  const auto input = read(text);
  if (!input.error.empty()) {
    typing.refused[name] = {text, input.error, shown, ImGui::GetFrameCount()};
    reason(ctx, name, input.error);
  }
  if (!input.value || *input.value == value) return false;
  value = *input.value;
  return true;
}

// Whether the slider or drag is a field for typing now. A Ctrl+click or Enter makes it one.
template <class Number>
bool is_field(PanelContext& ctx, const char* name, const Number& value) {
  NumberTyping& typing = ctx.state.number;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end{corner.x + ImGui::CalcItemWidth(), corner.y + ImGui::GetFrameHeight()};
  const bool over = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, end);
  const bool clicked = ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0) && over;
  const RefusedNumber* const refused = refused_in(ctx, name);
  if ((wants_typing(ctx, name) || clicked) && typing.name != name && refused == nullptr) {
    typing.name = name;
    typing.text = shortest_number(value);
    typing.focus = true;
  }
  return typing.name == name || refused != nullptr;
}

}  // namespace

bool has_refused_number(PanelContext& ctx, const std::string& dialog) {
  const auto& all = ctx.state.number.refused;
  return std::any_of(all.begin(), all.end(), [&](const auto& one) {
    return one.first.starts_with(dialog + ".") && one.second.frame + 1 >= ImGui::GetFrameCount();
  });
}

void forget_typing(PanelContext& ctx, const std::string& name) {
  ctx.state.number.refused.erase(name);
}

bool number_field(PanelContext& ctx, const char* name, double& value, const NumberRule& rule) {
  return field(ctx, name, value, [&](const std::string& text) { return read_number(text, rule); });
}

bool number_field(PanelContext& ctx, const char* name, Alpha& value) {
  return field(ctx, name, value, [](const std::string& text) { return read_alpha(text); });
}

bool number_field(PanelContext& ctx, const char* name, int& value, const NumberRule& rule) {
  double number = value;
  if (!number_field(ctx, name, number, rule)) return false;
  value = static_cast<int>(std::lround(number));
  return true;
}

bool draw_typed_number(PanelContext& ctx, const char* name, double& value, const NumberRule& rule,
                       bool& changed) {
  if (!is_field(ctx, name, value)) return false;
  changed = number_field(ctx, name, value, rule);
  return true;
}

bool draw_typed_number(PanelContext& ctx, const char* name, Alpha& value, bool& changed) {
  if (!is_field(ctx, name, value)) return false;
  changed = number_field(ctx, name, value);
  return true;
}

bool number_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                   const NumberRule& rule) {
  bool changed = false;
  if (draw_typed_number(ctx, name, value, rule, changed)) return changed;
  ImGui::PushID(name);
  changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &low, &high, "",
                                ImGuiSliderFlags_NoInput);
  ImGui::PopID();
  record(ctx, name);
  key_stop(ctx, name, KeyStop::slide);
  constexpr double kSteps = 50;  // from one end of the slider to the other
  if (const int steps = key_steps(ctx, name); steps != 0) {
    value = std::clamp(value + steps * (high - low) / kSteps, low, high);
    changed = true;
  }
  return changed;
}

}  // namespace alphascope
