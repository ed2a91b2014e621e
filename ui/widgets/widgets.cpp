// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the common widgets, and records the rectangle of each by its name.
#include "ui/widgets/widgets.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/chart/colour_scale.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/export/program_name.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/calls.hpp"
#include "ui/fitted_text.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/frame/scroll_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/number_typing.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {

ImVec4 to_imgui(const Colour& c, float alpha) {
  return {c.r, c.g, c.b, c.a * alpha};
}

ImU32 to_u32(const Colour& c, float alpha) {
  return ImGui::ColorConvertFloat4ToU32(to_imgui(c, alpha));
}

void record(PanelContext& ctx, const char* name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImDrawList* drawn = ImGui::GetWindowDrawList();
  const float middle = (low.y + high.y) / 2;
  const bool visible = ImGui::IsItemVisible() && middle >= drawn->GetClipRectMin().y &&
                       middle <= drawn->GetClipRectMax().y;
  ctx.rects[name] = {low.x, low.y, high.x, high.y, visible};
  if (ctx.state.scroll.widget == name) {
    ImGui::SetScrollHereY();
    ctx.state.scroll.widget.clear();
  }
}

bool button(PanelContext& ctx, const char* name, const char* label, ImVec2 size, ButtonKind kind) {
  int pushed = 0;
  const Palette& p = ctx.palette;
  if (kind == ButtonKind::primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(p.accent));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, to_imgui(p.accent_hovered));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, to_imgui(p.accent));
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(p.accent_text));
    pushed = 4;
  } else if (kind == ButtonKind::quiet) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    pushed = 1;
  }
  ImGui::PushID(name);
  const bool clicked = ImGui::Button(label, size);
  ImGui::PopID();
  ImGui::PopStyleColor(pushed);
  record(ctx, name);
  key_stop(ctx, name);
  return clicked;
}

float button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

float checkbox_width(const char* label) {
  return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
         ImGui::CalcTextSize(label).x;
}

void same_line_where_it_fits(float width, float gap) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0, gap);
}

bool checkbox(PanelContext& ctx, const char* name, const char* label, bool& value) {
  ImGui::PushID(name);
  const bool changed = ImGui::Checkbox(label, &value);
  ImGui::PopID();
  record(ctx, name);
  key_stop(ctx, name);
  return changed;
}

bool text_field(PanelContext& ctx, const char* name, std::string& text, const char* hint,
                KeyStop kind) {
  KeyState& keys = ctx.state.keys;
  const ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | caret_flags(ctx, name);
  ImGui::PushID(name);
  // While a field is typed into, ImGui keeps a copy of its text. If the program has changed the
  // text, typing ends here, since the copy would overwrite the change.
  const bool active = GImGui->ActiveId == ImGui::GetID("##text");
  if (active && keys.field == name && keys.field_text != text) ImGui::ClearActiveID();
  const bool entered = ImGui::InputTextWithHint("##text", hint, &text, flags, &place_caret, &keys);
  ImGui::PopID();
  if (ImGui::IsItemActive()) {
    keys.field = name;
    keys.field_text = text;
  }
  record(ctx, name);
  key_stop(ctx, name, kind);
  return entered;
}

bool list_field(PanelContext& ctx, const char* name, const char* chosen, ImGuiComboFlags flags) {
  const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), chosen, flags);
  record(ctx, name);
  if (open) {
    close_on_escape();
  } else {
    key_stop(ctx, name);
  }
  return open;
}

void open_browser(ViewState& state, BrowserPurpose purpose) {
  state.browser.purpose = purpose;
  state.browser.show = true;
}

bool choice(PanelContext& ctx, const char* name, std::initializer_list<const char*> labels,
            int& chosen, float width) {
  bool changed = false;
  const float gap = ctx.px(2);
  const float each =
      (width - gap * static_cast<float>(labels.size() - 1)) / static_cast<float>(labels.size());
  int index = 0;
  for (const char* label : labels) {
    if (index > 0) ImGui::SameLine(0, gap);
    const bool on = index == chosen;
    const std::string id = std::string(name) + "." + std::to_string(index);
    if (on) {
      ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(ctx.palette.accent, 0.30f));
      ImGui::PushStyleColor(ImGuiCol_ButtonHovered, to_imgui(ctx.palette.accent, 0.36f));
    }
    if (button(ctx, id.c_str(), label, {each, 0}) && !on) {
      chosen = index;
      changed = true;
    }
    if (on) ImGui::PopStyleColor(2);
    ++index;
  }
  return changed;
}

void row_label(PanelContext& ctx, const char* label, float reserve) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(ctx.px(112));
  ImGui::SetNextItemWidth(reserve > 0 ? -ctx.px(reserve) : -1);
}

bool value_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                  const NumberRule& rule, const std::string& text, float reserve) {
  const float text_width = ctx.px(48);
  ImGui::SetNextItemWidth(-ctx.px(reserve) - text_width);
  const bool changed = number_slider(ctx, name, value, low, high, rule);
  const ImGuiLastItemData slider = GImGui->LastItemData;
  const float right = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + text_width;
  ImGui::SameLine(right - ImGui::CalcTextSize(text.c_str()).x);
  ImGui::TextUnformatted(text.c_str());
  GImGui->LastItemData = slider;  // tooltips refer to the slider
  return changed;
}

bool percent_slider(PanelContext& ctx, const char* name, float& value, float low, float high) {
  double percent = std::round(value * 100);
  const std::string text = number_text(percent, 0) + " %";
  const double least = std::round(low * 100), most = std::round(high * 100);
  const NumberRule rule{"The value", least, most, "%"};
  if (!value_slider(ctx, name, percent, least, most, rule, text)) return false;
  value = std::clamp(static_cast<float>(std::round(percent) / 100), low, high);
  return true;
}

bool disclosure(PanelContext& ctx, const char* name, const std::string& title,
                const Colour& colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(colour));
  const bool open = ImGui::TreeNodeEx(name, ImGuiTreeNodeFlags_SpanAvailWidth, "%s", title.c_str());
  ImGui::PopStyleColor();
  record(ctx, name);
  key_stop(ctx, name);
  return open;
}

void nothing_to_disclose(PanelContext& ctx, const char* text) {
  const float indent = ImGui::GetTreeNodeToLabelSpacing();
  ImGui::Indent(indent);
  muted_text(ctx, text);
  ImGui::Unindent(indent);
}

void reserve_lines(float top, int lines) {
  const float bottom = top + static_cast<float>(lines) * ImGui::GetTextLineHeight() +
                       ImGui::GetStyle().ItemSpacing.y;
  if (ImGui::GetCursorPosY() < bottom) ImGui::SetCursorPosY(bottom);
}

void close_on_escape() {
  if (ImGui::IsKeyPressed(key::kEscape, false) && !ImGui::GetIO().WantTextInput) {
    ImGui::CloseCurrentPopup();
  }
}

bool section(PanelContext& ctx, const char* name, const char* title) {
  ImGui::Dummy({0, ctx.px(2)});
  ImGui::PushFont(ctx.fonts.strong);
  ImGui::PushStyleColor(ImGuiCol_Header, to_imgui(ctx.palette.panel_raised));
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, to_imgui(ctx.palette.field));
  ImGui::PushStyleColor(ImGuiCol_HeaderActive, to_imgui(ctx.palette.field));
  const bool wanted = ctx.state.scroll.section == name;
  auto& closed = ctx.state.window.closed_sections;  // sessions save this set, and not ImGui's own
                                                    // state
  if (wanted) closed.erase(name);
  ImGui::SetNextItemOpen(!closed.contains(name));
  const bool open = ImGui::CollapsingHeader(title);
  if (open) {
    closed.erase(name);
  } else {
    closed.insert(name);
  }
  ImGui::PopStyleColor(3);
  ImGui::PopFont();
  record(ctx, name);
  key_stop(ctx, name);
  if (wanted) {
    ImGui::SetScrollHereY(0);
    ctx.state.scroll.section.clear();
  }
  return open;
}

namespace {

// Places a tooltip below a field or button, or above it if there is no room below. In a menu or
// list it lies beside the list. For large items, such as the view, it stays at the mouse.
void place_tooltip(const PanelContext& ctx, ImVec2 size) {
  const ImGuiLastItemData& item = GImGui->LastItemData;
  const ImGuiWindow* const window = GImGui->CurrentWindow;
  const ImVec2 display = ImGui::GetIO().DisplaySize, mouse = ImGui::GetIO().MousePos;
  const float gap = ctx.px(6);
  const bool in_list = (window->Flags & ImGuiWindowFlags_Popup) != 0 &&
                       (window->Flags & ImGuiWindowFlags_Modal) == 0;
  if (in_list) {
    const float right = window->Pos.x + window->Size.x + gap;
    const bool fits = right + size.x <= display.x;
    const float y = std::clamp(item.Rect.Min.y, 0.0f, std::max(0.0f, display.y - size.y));
    return ImGui::SetNextWindowPos({fits ? right : window->Pos.x - gap, y}, ImGuiCond_Always,
                                   {fits ? 0.0f : 1.0f, 0});
  }
  constexpr float kLarge = 60;  // pixels at scale 1
  if (item.Rect.GetHeight() > ctx.px(kLarge)) return;
  const float x = std::clamp(mouse.x, 0.0f, std::max(0.0f, display.x - size.x));
  const bool below = item.Rect.Max.y + gap + size.y <= display.y;
  ImGui::SetNextWindowPos({x, below ? item.Rect.Max.y + gap : item.Rect.Min.y - gap},
                          ImGuiCond_Always, {0, below ? 0.0f : 1.0f});
}

}  // namespace

void tooltip(PanelContext& ctx, const char* text) {
  if (ctx.state.mouse.still_seconds < kTooltipDelaySeconds) return;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  // The reason why a number was refused stands where the tooltip would be.
  const NumberTyping& number = ctx.state.number;
  const ImVec2 corner = ImGui::GetItemRectMin();
  const bool refused = number.reason_frame == ImGui::GetFrameCount() &&
                       number.reason_x == corner.x && number.reason_y == corner.y;
  if (refused) return;
  const float wrap = ImGui::GetFontSize() * 24;
  const ImVec2 room = ImGui::CalcTextSize(text, nullptr, false, wrap);
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  place_tooltip(ctx, {room.x + 2 * padding.x, room.y + 2 * padding.y});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(wrap);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void muted_text(PanelContext& ctx, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void muted_wrapped(PanelContext& ctx, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  wrapped_text(text);
  ImGui::PopStyleColor();
}

std::string broken_lines(const std::string& text, float width) {
  std::string lines = text;
  std::size_t line = 0, last_blank = std::string::npos;
  for (std::size_t i = 0; i <= lines.size(); ++i) {
    if (i < lines.size() && lines[i] != ' ' && lines[i] != '\n') continue;
    const bool too_long = ImGui::CalcTextSize(lines.data() + line, lines.data() + i).x > width;
    if (too_long && last_blank != std::string::npos) {
      lines[last_blank] = '\n';
      line = last_blank + 1;
    }
    last_blank = i;
    if (i < lines.size() && lines[i] == '\n') {
      line = i + 1;
      last_blank = std::string::npos;
    }
  }
  return lines;
}

void wrapped_text(const std::string& text) {
  const std::string lines = broken_lines(text, ImGui::GetContentRegionAvail().x);
  ImGui::PushTextWrapPos(0);  // for words that are wider than a line
  ImGui::TextUnformatted(lines.c_str());
  ImGui::PopTextWrapPos();
}

void strong_text(PanelContext& ctx, const std::string& text) {
  ImGui::PushFont(ctx.fonts.strong);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

std::string fitted_text(const std::string& text, float width) {
  return fitted_text(text, width,
                     [](const std::string& some) { return ImGui::CalcTextSize(some.c_str()).x; });
}

}  // namespace alphascope
