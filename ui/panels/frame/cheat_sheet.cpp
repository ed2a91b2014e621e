// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that lists what mouse and keys do. The keys come from the list of commands.
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {
namespace {

// Pixels at scale 1. The keys are in three parts beside each other, so the dialog is lower than a
// window of 700 pixels.
constexpr std::size_t kColumns = 3;
constexpr float kMouseWidth = 180, kKeysWidth = 115, kWhatWidth = 195;
constexpr float kWidth = kColumns * (kKeysWidth + kWhatWidth);

// Actions of the mouse, which are not commands.
constexpr std::pair<const char*, const char*> kMouse[] = {
    {"Drag", "Turn the view"},
    {"Middle drag, Shift+drag", "Pan the view"},
    {"Wheel, right drag", "Zoom"},
    {"Hover over a ball or simplex", "Show its name and values"},
    {"Click", "Select it; on the background: clear the selection"},
    {"Right click", "Open its menu"},
    {"Ctrl+click, Shift+click", "Add it to the selection, or remove it"},
    {"Ctrl+click on a slider", "Type the value"},
    {"Drop a file", "Open a molecule or a session"}};

struct Row {
  std::string keys, what;
};

// Keys that move through fields and menus, which are not commands either.
const Row kPlaces[] = {{"Tab, Shift+Tab", "Next, previous field or button"},
                       {"Space, Enter", "Press it"},
                       {"Alt, F10", "Menu bar"}};

void cells(PanelContext& ctx, const Row& row) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.keys.c_str());
  ImGui::TableNextColumn();
  muted_text(ctx, row.what);
}

bool begin_rows(PanelContext& ctx, const char* title, std::initializer_list<float> widths) {
  strong_text(ctx, title);
  if (!ImGui::BeginTable(title, static_cast<int>(widths.size()))) return false;
  for (const float width : widths) {
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ctx.px(width));
  }
  return true;
}

void end_rows(PanelContext& ctx) {
  ImGui::EndTable();
  ImGui::Dummy({0, ctx.px(4)});
}

std::string without_dots(std::string title) {
  constexpr std::string_view kDots = "…";
  if (title.ends_with(kDots)) title.resize(title.size() - kDots.size());
  return title;
}

void add_command(const CommandSpec& spec, std::vector<Row>& rows) {
  const std::string title = without_dots(spec.title), keys = spec.shortcuts_text();
  if (!keys.empty()) rows.push_back({keys, title + (spec.is_switch() ? " on or off" : "")});
  for (const Shortcut& shortcut : spec.shortcuts) {
    if (shortcut.arguments.empty()) continue;
    const std::string unit = spec.parameters.empty() ? "" : spec.parameters[0].unit();
    std::string argument = shortcut.arguments;  // in the form that users type
    if (argument.starts_with('-')) argument.replace(0, 1, "−");
    rows.push_back({shortcut.keys, title + " " + argument + (unit.empty() ? "" : " " + unit)});
  }
  for (const Shortcut& shortcut : spec.keys_before_others) rows.push_back({shortcut.keys, title});
}

}  // namespace

void draw_cheat_sheet(PanelContext& ctx) {
  if (!begin_dialog(ctx, "Mouse and keyboard")) return;
  if (begin_rows(ctx, "Mouse", {kMouseWidth, kWidth - kMouseWidth})) {
    for (const auto& [keys, what] : kMouse) cells(ctx, {keys, what});
    end_rows(ctx);
  }
  std::vector<Row> rows(std::begin(kPlaces), std::end(kPlaces));
  for (const CommandSpec& spec : ctx.commands.all()) add_command(spec, rows);
  if (begin_rows(ctx, "Keyboard",
                 {kKeysWidth, kWhatWidth, kKeysWidth, kWhatWidth, kKeysWidth, kWhatWidth})) {
    const std::size_t lines = (rows.size() + kColumns - 1) / kColumns;
    rows.resize(lines * kColumns);
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t column = 0; column < kColumns; ++column) {
        cells(ctx, rows[column * lines + line]);
      }
    }
    end_rows(ctx);
  }
  ImGui::NewLine();
  if (close_button(ctx, ctx.px(kWidth + 8), {"cheat_sheet.close", "Close"})) {
    ctx.state.dialogs.show_cheat_sheet = false;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
