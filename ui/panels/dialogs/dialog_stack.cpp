// SPDX-License-Identifier: GPL-3.0-or-later
// Lists all dialogs. Opens, nests and closes them, and leads keys to the topmost one.
#include "ui/panels/dialogs/dialog_stack.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/document/commands/commands.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/dialogs/session_problem.hpp"
#include "ui/panels/dialogs/table_state.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/number_field.hpp"

namespace alphascope {
namespace {

constexpr float kMargin = 8;  // pixels at scale 1 between a dialog and the window's edge
constexpr const char* kBody = "body";

struct Entry {
  bool (*wanted)(const ViewState& state);
  void (*draw)(PanelContext& ctx);
};

// DialogState::open holds indices into this list.
constexpr std::array kDialogs{
    Entry{[](const ViewState& s) { return s.dialogs.show_benchmark; }, draw_benchmark_dialog},
    Entry{[](const ViewState& s) { return s.browser.show; }, draw_file_browser},
    Entry{[](const ViewState& s) { return s.fetch.show; }, draw_fetch},
    Entry{[](const ViewState& s) { return s.dialogs.show_save; }, draw_save_picture},
    Entry{[](const ViewState& s) { return s.record.show; }, draw_record},
    Entry{[](const ViewState& s) { return s.save_table.table != nullptr; }, draw_save_table},
    Entry{[](const ViewState& s) { return s.dialogs.show_export; }, draw_export},
    Entry{[](const ViewState& s) { return s.dialogs.show_save_session; }, draw_save_session},
    Entry{[](const ViewState& s) { return s.session_problem.has_value(); }, draw_session_problem},
    Entry{[](const ViewState& s) { return !s.dialogs.confirm_assembly.empty(); },
          draw_confirm_assembly},
    Entry{[](const ViewState& s) { return s.dialogs.show_cheat_sheet; }, draw_cheat_sheet},
    Entry{[](const ViewState& s) { return s.dialogs.show_about; }, draw_about},
    Entry{[](const ViewState& s) { return s.palette.show; }, draw_command_palette},
    Entry{[](const ViewState& s) { return !s.error.empty(); }, draw_error}};

bool wanted(const ViewState& state, std::size_t kind) {
  return kDialogs[kind].wanted(state);
}

void draw_level(PanelContext& ctx) {
  const auto& open = ctx.state.dialogs.open;
  if (ctx.dialog >= open.size()) return;
  ++ctx.level;
  kDialogs[open[ctx.dialog]].draw(ctx);
  --ctx.level;
}

}  // namespace

bool begin_dialog(PanelContext& ctx, const char* title, ImVec2 size, DialogPlace place) {
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const bool top = place == DialogPlace::top;
  ImGui::SetNextWindowPos({display.x / 2, top ? 2 * ImGui::GetFrameHeight() : display.y / 2},
                          ImGuiCond_Always, {0.5f, top ? 0 : 0.5f});
  ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (size.x > 0) {
    ImGui::SetNextWindowSize(size);
  } else {
    flags |= ImGuiWindowFlags_AlwaysAutoResize;
  }
  if (top) flags |= ImGuiWindowFlags_NoTitleBar;
  (void)ctx;
  return ImGui::BeginPopupModal(title, nullptr, flags);
}

void end_dialog(PanelContext& ctx) {
  if (!wanted(ctx.state, ctx.state.dialogs.open[ctx.dialog])) {
    ImGui::CloseCurrentPopup();  // also closes dialogs above it, which open again in the next frame
  } else {
    ++ctx.dialog;
    draw_level(ctx);
    --ctx.dialog;
  }
  ImGui::EndPopup();
}

float dialog_room(const PanelContext& ctx) {
  const ImGuiStyle& style = ImGui::GetStyle();
  return ImGui::GetIO().DisplaySize.x - 2 * style.WindowPadding.x - style.ScrollbarSize -
         2 * ctx.px(kMargin);
}

void begin_dialog_body(PanelContext& ctx, float width) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float buttons = 2 * ImGui::GetFrameHeightWithSpacing();
  const float room = ImGui::GetIO().DisplaySize.y - ImGui::GetFrameHeight() -
                     2 * style.WindowPadding.y - buttons - 2 * ctx.px(kMargin);
  const float wanted = ImGui::GetStateStorage()->GetFloat(ImGui::GetID(kBody), room);
  ImGui::BeginChild(kBody,
                    {wanted > room ? width + style.ScrollbarSize : width, std::min(wanted, room)});
}

void end_dialog_body() {
  const float wanted = ImGui::GetCursorPosY();
  ImGui::EndChild();
  ImGui::GetStateStorage()->SetFloat(ImGui::GetID(kBody), wanted);
}

bool on_top(const PanelContext& ctx) {
  return ctx.dialog + 1 == ctx.state.dialogs.open.size();
}

bool has_keys(const PanelContext& ctx) {
  return on_top(ctx) && !ctx.state.keys.list_open && !ImGui::GetIO().WantTextInput;
}

bool escape_pressed(const PanelContext& ctx) {
  const KeyState& keys = ctx.state.keys;
  const bool of_dialog = has_keys(ctx) || (keys.untouched && on_top(ctx) && !keys.list_open);
  return of_dialog && ImGui::IsKeyPressed(key::kEscape, false);
}

bool enter_pressed(const PanelContext& ctx) {
  return has_keys(ctx) && !ctx.state.keys.enter_used &&
         (ImGui::IsKeyPressed(key::kEnter, false) || ImGui::IsKeyPressed(key::kKeypadEnter, false));
}

bool entered_field(const PanelContext& ctx) {
  return on_top(ctx) && !ctx.state.keys.entered.empty();
}

DialogAnswer dialog_buttons(PanelContext& ctx, float width, DialogButton cancel,
                            DialogButton confirm, bool can_confirm, bool entered) {
  const float each = ctx.px(100), gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + width - 2 * each - gap);
  const bool no = button(ctx, cancel.name, cancel.label, {each, 0}) || escape_pressed(ctx);
  ImGui::SameLine();
  const std::string_view name = confirm.name;
  can_confirm &= !has_refused_number(ctx, std::string(name.substr(0, name.find('.'))));
  ImGui::BeginDisabled(!can_confirm);
  const bool clicked = button(ctx, confirm.name, confirm.label, {each, 0}, ButtonKind::primary);
  ImGui::EndDisabled();
  const bool ended = entered_field(ctx);
  const bool yes = clicked || (can_confirm && (entered || ended || enter_pressed(ctx)));
  // Enter ends typing. If it is refused, the field gets the keyboard again, to be corrected. A
  // field for a number only gets its mark, since typing would hide the reason below it.
  if (entered && !yes && !no) type_into(ctx, ctx.state.keys.at.back().name);
  if (ended && !yes && !no) ctx.state.keys.at.back().shown = true;
  return yes ? DialogAnswer::confirm : no ? DialogAnswer::cancel : DialogAnswer::none;
}

bool close_button(PanelContext& ctx, float width, DialogButton close) {
  const float each = ctx.px(100);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + width - each);
  return button(ctx, close.name, close.label, {each, 0}, ButtonKind::primary) ||
         escape_pressed(ctx) || enter_pressed(ctx);
}

void draw_dialogs(PanelContext& ctx) {
  auto& open = ctx.state.dialogs.open;
  for (std::size_t kind = 0; kind < kDialogs.size(); ++kind) {
    const bool there = std::find(open.begin(), open.end(), kind) != open.end();
    if (!there && wanted(ctx.state, kind)) open.push_back(kind);
  }
  ctx.dialog = 0;
  draw_level(ctx);
  std::erase_if(open, [&](std::size_t kind) { return !wanted(ctx.state, kind); });
}

}  // namespace alphascope
