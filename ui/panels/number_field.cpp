// See the header.
#include "ui/panels/number_field.hpp"

// Needs imgui.h first.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/molecule/shortest_number.hpp"
#include "ui/panels/key_focus.hpp"

namespace alphascope {
namespace {

// Over what is below, so that nothing moves.
void reason(PanelContext& ctx, const char* name, const std::string& text) {
  const WidgetRect field = ctx.rects[name];
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoInputs |
                                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize;
  ImGui::SetNextWindowPos({field.x0, field.y1 + ctx.px(3)});
  ImGui::Begin("##number_reason", nullptr, kFlags);
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ctx.px(280));  // for what has no blanks
  ImGui::TextUnformatted(broken_lines(text, ctx.px(280)).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  record(ctx, (std::string(name) + ".error").c_str());
  ImGui::End();
}

// True when the typing is over and the text was changed.
bool type(PanelContext& ctx, const char* name, const std::string& shown, std::string& text) {
  NumberTyping& typing = ctx.state.memory.number;
  const bool mine = typing.name == name, wrong = mine && !typing.error.empty();
  text = mine ? typing.text : shown;
  if (mine && std::exchange(typing.focus, false)) ImGui::SetKeyboardFocusHere();
  if (wrong) {
    ImGui::PushStyleColor(ImGuiCol_Border, to_imgui(ctx.palette.error));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, ctx.px(1));
  }
  ImGui::PushID(name);
  ImGui::InputText("##number", &text, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopID();
  if (wrong) {
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
  }
  record(ctx, name);
  key_stop(ctx, name, KeyStop::type_when_asked);
  if (ImGui::IsItemActivated()) {
    typing.error.clear();
    if (typing.name != name) typing = {name, shown, {}};
  }
  if (typing.name == name) typing.text = text;
  return ImGui::IsItemDeactivated();
}

// `read` makes the value of the text, or says why not.
template <class Number, class Read>
bool field(PanelContext& ctx, const char* name, Number& value, const Read& read) {
  NumberTyping& typing = ctx.state.memory.number;
  const std::string shown = shortest_number(value);
  std::string text;
  const bool over = type(ctx, name, shown, text);
  if (typing.name != name) return false;
  bool changed = false;
  if (over) {
    const auto input = read(text);
    changed = input.value && *input.value != value;
    if (changed) value = *input.value;
    typing.error = text == shown ? "" : input.error;
    if (typing.error.empty()) typing = {};
  } else if (!typing.error.empty() && !ImGui::IsItemHovered() && ImGui::IsMouseClicked(0)) {
    typing = {};  // given up
  }
  if (!typing.error.empty()) reason(ctx, name, typing.error);
  return changed;
}

// True when a click with Ctrl, or Enter, has made it a field.
template <class Number>
bool is_field(PanelContext& ctx, const char* name, const Number& value) {
  NumberTyping& typing = ctx.state.memory.number;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end{corner.x + ImGui::CalcItemWidth(), corner.y + ImGui::GetFrameHeight()};
  const bool clicked = ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0) &&
                       ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, end);
  if ((wants_typing(ctx, name) || clicked) && typing.name != name) {
    typing = {name, shortest_number(value), {}, true};
  }
  return typing.name == name;
}

}  // namespace

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

bool typed_instead(PanelContext& ctx, const char* name, double& value, const NumberRule& rule,
                   bool& changed) {
  if (!is_field(ctx, name, value)) return false;
  changed = number_field(ctx, name, value, rule);
  return true;
}

bool typed_instead(PanelContext& ctx, const char* name, Alpha& value, bool& changed) {
  if (!is_field(ctx, name, value)) return false;
  changed = number_field(ctx, name, value);
  return true;
}

bool number_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                   const NumberRule& rule) {
  bool changed = false;
  if (typed_instead(ctx, name, value, rule, changed)) return changed;
  ImGui::PushID(name);
  changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &low, &high, "",
                                ImGuiSliderFlags_NoInput);
  ImGui::PopID();
  record(ctx, name);
  key_stop(ctx, name, KeyStop::slide);
  constexpr double kSteps = 50;  // from one end to the other
  if (const int steps = key_steps(ctx, name); steps != 0) {
    value = std::clamp(value + steps * (high - low) / kSteps, low, high);
    changed = true;
  }
  return changed;
}

}  // namespace alphascope
