// What mouse and keys do: the keys from the list of commands.
#include <utility>

#include "ui/panels/dialog_stack.hpp"

namespace alphascope {
namespace {

constexpr float kKeysWidth = 150, kWidth = 470;  // pixels at scale 1

// The mouse has no commands.
constexpr std::pair<const char*, const char*> kMouse[] = {
    {"Drag", "Turn the view"},
    {"Middle drag, Shift+drag", "Pan the view"},
    {"Wheel, right drag", "Zoom"},
    {"Hover over a ball or simplex", "Say what it is"},
    {"Click", "Select it; beside everything: select nothing"},
    {"Ctrl+click, Shift+click", "Add it to the selection, or take it out"},
    {"Ctrl+click on a slider", "Type the value"},
    {"Drop a file", "Open a molecule or a session"}};

void row(PanelContext& ctx, const std::string& keys, const std::string& what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(keys.c_str());
  ImGui::TableNextColumn();
  muted_text(ctx, what);
}

bool begin_rows(PanelContext& ctx, const char* title) {
  strong_text(ctx, title);
  if (!ImGui::BeginTable(title, 2)) return false;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, ctx.px(kKeysWidth));
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, ctx.px(kWidth - kKeysWidth));
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

void command_rows(PanelContext& ctx, const CommandSpec& spec) {
  const std::string title = without_dots(spec.title), keys = spec.shortcuts_text();
  if (!keys.empty()) row(ctx, keys, title + (spec.is_switch() ? " on or off" : ""));
  for (const Shortcut& shortcut : spec.shortcuts) {
    if (shortcut.arguments.empty()) continue;
    const std::string unit = spec.parameters.empty() ? "" : spec.parameters[0].unit();
    row(ctx, shortcut.keys, title + " " + shortcut.arguments + (unit.empty() ? "" : " " + unit));
  }
}

}  // namespace

void draw_cheat_sheet(PanelContext& ctx) {
  if (!begin_dialog(ctx, "Mouse and keyboard")) return;
  if (begin_rows(ctx, "Mouse")) {
    for (const auto& [keys, what] : kMouse) row(ctx, keys, what);
    end_rows(ctx);
  }
  if (begin_rows(ctx, "Keyboard")) {
    for (const CommandSpec& spec : ctx.commands.all()) command_rows(ctx, spec);
    end_rows(ctx);
  }
  ImGui::NewLine();
  if (close_button(ctx, ctx.px(kWidth + 8), {"cheat_sheet.close", "Close"})) {
    ctx.state.memory.show_cheat_sheet = false;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
