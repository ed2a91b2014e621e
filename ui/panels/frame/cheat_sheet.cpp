// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that lists what mouse and keys do. The keys come from the list of commands.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {
namespace {

// Pixels at scale 1. Three parts of the keys beside each other are lower than a window of 700.
constexpr std::size_t kMostColumns = 3;
constexpr float kMouseWidth = 180, kKeysWidth = 115, kWhatWidth = 195;
constexpr float kColumnWidth = kKeysWidth + kWhatWidth;

// Actions of the mouse, which are not commands.
constexpr std::pair<const char*, const char*> kMouse[] = {
    {"Drag", "Turn the view"},
    {"Middle drag; wheel", "Pan the view (also Shift+drag); zoom (also right drag)"},
    {"Hover over a ball or simplex", "Show its name and values"},
    {"Click", "Select it; with Ctrl or Shift: add it or remove it; on the background: clear"},
    {"Double click", "Move it to the middle: the view turns about it"},
    {"Right click", "Open its menu"},
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

bool begin_rows(PanelContext& ctx, const char* title, std::span<const float> widths) {
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
  const float room = dialog_room(ctx);
  const auto columns = std::clamp<std::size_t>(
      static_cast<std::size_t>(room / ctx.px(kColumnWidth)), 1, kMostColumns);
  const float width = std::min(room, ctx.px(kColumnWidth * static_cast<float>(columns) + 8));
  begin_dialog_body(ctx, width);
  if (begin_rows(ctx, "Mouse", std::array{kMouseWidth, kColumnWidth * 2 - kMouseWidth})) {
    for (const auto& [keys, what] : kMouse) cells(ctx, {keys, what});
    end_rows(ctx);
  }
  std::vector<Row> rows(std::begin(kPlaces), std::end(kPlaces));
  for (const CommandSpec& spec : ctx.commands.all()) add_command(spec, rows);
  std::vector<float> widths;
  for (std::size_t column = 0; column < columns; ++column) {
    widths.insert(widths.end(), {kKeysWidth, kWhatWidth});
  }
  if (begin_rows(ctx, "Keyboard", widths)) {
    const std::size_t lines = (rows.size() + columns - 1) / columns;
    rows.resize(lines * columns);
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t column = 0; column < columns; ++column) {
        cells(ctx, rows[column * lines + line]);
      }
    }
    end_rows(ctx);
  }
  end_dialog_body();
  ImGui::NewLine();
  if (close_button(ctx, width, {"cheat_sheet.close", "Close"})) {
    ctx.state.dialogs.show_cheat_sheet = false;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
