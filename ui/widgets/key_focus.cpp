// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the keyboard between fields and buttons. imgui.h of ImGui 1.86 has no function to press
// an item by its id, so this uses imgui_internal.h.
#include "ui/widgets/key_focus.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/frame/scroll_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr int kF10 = key::kF1 + 9;

KeyState& keys_of(PanelContext& ctx) {
  return ctx.state.keys;
}

// Whether the topmost popup is a menu or list; dialogs are popups as well.
bool list_on_top() {
  const ImVector<ImGuiPopupData>& open = GImGui->OpenPopupStack;
  if (open.empty()) return false;
  const ImGuiWindow* const window = open.back().Window;
  return window != nullptr && (window->Flags & ImGuiWindowFlags_Modal) == 0;
}

bool went_down(int code) {
  return ImGui::IsKeyPressed(code, false);
}

bool is_alt(int code) {
  return code == key::kLeftAlt || code == key::kRightAlt;
}

bool anything_but_alt() {
  const ImGuiIO& io = ImGui::GetIO();
  for (int code = 0; code < IM_ARRAYSIZE(io.KeysDown); ++code) {
    if (io.KeysDown[code] && !is_alt(code)) return true;
  }
  return ImGui::IsAnyMouseDown() || io.MouseWheel != 0 || io.MouseWheelH != 0;
}

// Whether Alt was pressed and released alone; Alt+Tab and Alt with the mouse do not count.
bool alt_tapped(KeyState& keys) {
  const bool down = went_down(key::kLeftAlt) || went_down(key::kRightAlt);
  if (down) keys.alt_alone = true;
  if (anything_but_alt()) keys.alt_alone = false;
  const bool up = ImGui::IsKeyReleased(key::kLeftAlt) || ImGui::IsKeyReleased(key::kRightAlt);
  return up && std::exchange(keys.alt_alone, false);
}

// Alt and F10 open the menu bar, or close its open menus.
void menu_keys(KeyState& keys) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool tapped = alt_tapped(keys);
  const bool f10 = went_down(kF10) && !io.KeyCtrl && !io.KeyShift;
  if (!tapped && !f10) return;
  if (keys.list_open) {
    const int dialogs = static_cast<int>(keys.at.size()) - 1;
    ImGui::ClosePopupToLevel(dialogs, true);
  } else if (keys.at.size() == 1) {
    ImGui::ClearActiveID();
    keys.open_menu = keys.mark_list = true;
  }
}

// Keeps one place of the keyboard focus for the window and for each open dialog. When the topmost
// dialog closes, the place in the one below holds again.
void follow_dialogs(KeyState& keys, std::size_t dialogs) {
  if (dialogs + 1 > keys.at.size()) keys.fresh = true;
  if (dialogs + 1 < keys.at.size()) keys.fresh = false;
  keys.at.resize(dialogs + 1);
}

bool of_top(const KeyState& keys, const KeyState::Stop& stop) {
  return stop.level + 1 == keys.at.size();
}

const KeyState::Stop* find_stop(const KeyState& keys, const std::string& name) {
  const auto found = std::find_if(keys.stops.begin(), keys.stops.end(), [&](const auto& stop) {
    return of_top(keys, stop) && stop.name == name;
  });
  return found == keys.stops.end() ? nullptr : &*found;
}

bool types(KeyStop kind) {
  return kind == KeyStop::type || kind == KeyStop::path || kind == KeyStop::type_when_asked;
}

// Keeps the typed characters for the next frame. ImGui would drop them in the frame in which a
// field begins.
void hold_characters(KeyState& keys) {
  ImGuiIO& io = ImGui::GetIO();
  keys.held.assign(io.InputQueueCharacters.begin(), io.InputQueueCharacters.end());
  io.ClearInputCharacters();
}

void give_held_characters(KeyState& keys) {
  ImGuiIO& io = ImGui::GetIO();
  if (keys.held.empty()) return;
  std::vector<unsigned> all = std::exchange(keys.held, {});
  all.insert(all.end(), io.InputQueueCharacters.begin(), io.InputQueueCharacters.end());
  io.ClearInputCharacters();
  for (const unsigned character : all) io.AddInputCharacter(character);
}

void start_typing(KeyState& keys, const KeyState::Stop& stop) {
  hold_characters(keys);
  ImGuiContext& g = *GImGui;
  g.NavActivateInputId = stop.id;
  g.NavActivateFlags = ImGuiActivateFlags_PreferInput;
}

void press_stop(const KeyState::Stop& stop) {
  ImGuiContext& g = *GImGui;
  g.NavActivateId = g.NavActivateDownId = g.NavActivatePressedId = stop.id;
  g.NavActivateFlags = ImGuiActivateFlags_None;
}

void go_to_stop(PanelContext& ctx, const KeyState::Stop& stop) {
  keys_of(ctx).at.back() = {stop.name, true};
  if (!stop.visible) ctx.state.scroll.widget = stop.name;
  if (types(stop.kind)) start_typing(keys_of(ctx), stop);
}

// Leads the keyboard to the first text field of a dialog that has just opened, so the user can type
// at once.
void enter_dialog(PanelContext& ctx) {
  KeyState& keys = keys_of(ctx);
  const auto on_top = [&](const auto& stop) { return of_top(keys, stop); };
  if (!keys.fresh || std::none_of(keys.stops.begin(), keys.stops.end(), on_top)) return;
  keys.fresh = false;
  const auto first = std::find_if(keys.stops.begin(), keys.stops.end(), [&](const auto& stop) {
    return on_top(stop) && types(stop.kind);
  });
  if (first == keys.stops.end() || first->kind == KeyStop::type_when_asked) return;
  go_to_stop(ctx, *first);
  keys.untouched = true;
  if (first->kind == KeyStop::path) {
    keys.caret = first->name;
    keys.caret_selects = true;
  }
  keys.at.back().shown = false;
}

bool any_key_but_escape() {
  const ImGuiIO& io = ImGui::GetIO();
  for (int code = 0; code < IM_ARRAYSIZE(io.KeysDown); ++code) {
    const bool modifier = code >= key::kFirstModifier && code <= key::kLastModifier;
    if (code != key::kEscape && !modifier && went_down(code)) return true;
  }
  return !io.InputQueueCharacters.empty() || ImGui::IsAnyMouseDown();
}

void follow_tab(PanelContext& ctx) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsKeyPressed(key::kTab) || io.KeyCtrl || io.KeyAlt || ImGui::IsAnyMouseDown()) return;
  KeyState& keys = keys_of(ctx);
  std::vector<const KeyState::Stop*> stops;
  for (const auto& stop : keys.stops) {
    if (of_top(keys, stop)) stops.push_back(&stop);
  }
  if (stops.empty()) return;
  const std::size_t count = stops.size();
  const auto at = static_cast<std::size_t>(
      std::find(stops.begin(), stops.end(), find_stop(keys, keys.at.back().name)) - stops.begin());
  const std::size_t next = !io.KeyShift  ? (at == count ? 0 : (at + 1) % count)
                           : at == count ? count - 1
                                         : (at + count - 1) % count;
  stop_typing();
  go_to_stop(ctx, *stops[next]);
}

void press_keys(PanelContext& ctx) {
  KeyState& keys = keys_of(ctx);
  const ImGuiIO& io = ImGui::GetIO();
  const KeyState::Place& at = keys.at.back();
  if (!at.shown || io.WantTextInput || io.KeyCtrl || io.KeyAlt || GImGui->ActiveId != 0) return;
  const KeyState::Stop* const stop = find_stop(keys, at.name);
  if (stop == nullptr) return;
  const bool enter = went_down(key::kEnter) || went_down(key::kKeypadEnter);
  if (stop->kind == KeyStop::slide) {
    keys.steps =
        (ImGui::IsKeyPressed(key::kRight) ? 1 : 0) - (ImGui::IsKeyPressed(key::kLeft) ? 1 : 0);
    if (keys.steps != 0) keys.slid = stop->name;
  }
  if (!enter && !went_down(key::kSpace)) return;
  keys.enter_used = enter;
  if (stop->kind == KeyStop::press) {
    press_stop(*stop);
  } else if (types(stop->kind)) {
    start_typing(keys, *stop);
  } else {
    keys.typed = stop->name;
  }
}

void mark_stop(PanelContext& ctx) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float out = ctx.px(1);
  ImGui::GetWindowDrawList()->AddRect({low.x - out, low.y - out}, {high.x + out, high.y + out},
                                      to_u32(ctx.palette.accent),
                                      ImGui::GetStyle().FrameRounding + out, 0, ctx.px(2));
}

}  // namespace

void prepare_list_keys() {
  ImGuiIO& io = ImGui::GetIO();
  const bool list = list_on_top();
  if (list) {
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  } else {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  }
  // In ImGui 1.86 Enter activates only text fields, so this lets it activate entries of lists.
  const bool enter = io.KeysDown[key::kEnter] || io.KeysDown[key::kKeypadEnter];
  if (list && enter) io.NavInputs[ImGuiNavInput_Activate] = 1;
}

void begin_key_focus(PanelContext& ctx) {
  KeyState& keys = keys_of(ctx);
  keys.stops = std::exchange(keys.drawn, {});
  keys.list_open = list_on_top() || keys.list_at_end;
  keys.enter_used = false;
  keys.entered.clear();
  keys.slid.clear();
  give_held_characters(keys);
  if (std::exchange(keys.begins, false)) hold_characters(keys);
  follow_dialogs(keys, ctx.state.dialogs.open.size());
  if (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1)) keys.at.back().shown = false;
  menu_keys(keys);
  if (keys.list_open && std::exchange(keys.mark_list, false)) {
    GImGui->NavDisableHighlight = false;
    GImGui->NavDisableMouseHover = true;
  }
  if (keys.list_open) return;
  if (any_key_but_escape() || keys.at.size() == 1) keys.untouched = false;
  enter_dialog(ctx);
  press_keys(ctx);
  follow_tab(ctx);
}

void end_key_focus(PanelContext& ctx) {
  KeyState& keys = keys_of(ctx);
  keys.list_at_end = list_on_top();
  // In a menu of the bar, Left and Right lead to the neighbouring menu (menu_bar.cpp).
  const bool of_bar = keys.bar_menu >= 0 && !keys.in_submenu;
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_LeftArrow] = of_bar ? -1 : key::kLeft;
  io.KeyMap[ImGuiKey_RightArrow] = of_bar ? -1 : key::kRight;
}

void key_stop(PanelContext& ctx, const char* name, KeyStop kind) {
  KeyState& keys = keys_of(ctx);
  const ImGuiLastItemData& item = GImGui->LastItemData;
  if (item.ID == 0 || (item.InFlags & ImGuiItemFlags_Disabled) != 0) return;
  const auto drawn = ctx.rects.find(name);
  const bool visible = drawn == ctx.rects.end() || drawn->second.visible;
  keys.drawn.push_back({name, item.ID, ctx.level, kind, visible});
  if (ctx.level + 1 != keys.at.size()) return;
  KeyState::Place& at = keys.at.back();
  if (ImGui::IsItemActivated() && at.name != name) at = {name, false};
  if (at.shown && at.name == name) mark_stop(ctx);
}

void note_enter(PanelContext& ctx, const char* name) {
  const bool enter = went_down(key::kEnter) || went_down(key::kKeypadEnter);
  if (enter && ImGui::IsItemDeactivated()) keys_of(ctx).entered = name;
}

bool wants_typing(PanelContext& ctx, const std::string& name) {
  KeyState& keys = keys_of(ctx);
  if (keys.typed != name) return false;
  keys.typed.clear();
  return true;
}

int key_steps(PanelContext& ctx, const std::string& name) {
  return keys_of(ctx).slid == name ? keys_of(ctx).steps : 0;
}

void type_into(PanelContext& ctx, const std::string& name) {
  const KeyState::Stop* const stop = find_stop(keys_of(ctx), name);
  if (stop == nullptr) return;
  KeyState& keys = keys_of(ctx);
  keys.at.back() = {name, false};
  keys.caret = name;
  keys.caret_selects = false;
  keys.begins = true;
  GImGui->NavNextActivateId = stop->id;
  GImGui->NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
}

ImGuiInputTextFlags caret_flags(const PanelContext& ctx, const char* name) {
  return ctx.state.keys.caret == name ? ImGuiInputTextFlags_CallbackAlways : 0;
}

// Places the caret at the end. For a path it selects the file's name without number and ending:
// "frame" in "/data/frame-%04d.png".
int place_caret(ImGuiInputTextCallbackData* data) {
  KeyState& keys = *static_cast<KeyState*>(data->UserData);
  keys.caret.clear();
  data->ClearSelection();
  data->CursorPos = data->BufTextLen;
  if (!keys.caret_selects) return 0;
  const std::string_view text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  const std::size_t slash = text.rfind('/'), from = slash == text.npos ? 0 : slash + 1;
  const std::string_view name = text.substr(from);
  const std::size_t number = name.find("-%"), dot = name.rfind('.');
  const std::size_t length = std::min({number, dot == 0 ? name.npos : dot, name.size()});
  data->SelectionStart = static_cast<int>(from);
  data->SelectionEnd = data->CursorPos = static_cast<int>(from + length);
  return 0;
}

void stop_typing() {
  ImGui::ClearActiveID();
}

}  // namespace alphascope
