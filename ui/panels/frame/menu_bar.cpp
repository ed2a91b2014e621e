// SPDX-License-Identifier: GPL-3.0-or-later
// The menu bar and the keyboard shortcuts, both made from the list of commands.
#include <algorithm>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/key_state.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void run_command(PanelContext& ctx, const CommandSpec& spec,
                 const std::vector<std::string>& words) {
  const bool could = spec.reason_against().empty();
  const Outcome outcome = ctx.commands.run(spec.id, words);
  if (outcome.state == Outcome::State::failed) {
    ctx.state.show_error("“" + spec.title + "” failed", outcome.why,
                         kind_of(outcome.cause, ErrorKind::computing));
  } else if (could && !outcome.done()) {
    ctx.state.notice = outcome.why;
  }
}

namespace {

void choice_menu(PanelContext& ctx, const CommandSpec& spec, const Parameter& parameter,
                 bool enabled) {
  const std::vector<Choice> choices = parameter.choices();
  const std::string name = "menu." + spec.id;
  const bool open = ImGui::BeginMenu(spec.title.c_str(), enabled && !choices.empty());
  ctx.state.keys.in_submenu |= open || ImGui::IsItemFocused();
  record(ctx, name.c_str());
  if (!open) return;
  for (const Choice& choice : choices) {
    const bool clicked =
        ImGui::MenuItem(choice.title.c_str(), choice.detail.c_str(), choice.chosen);
    record(ctx, (name + "." + choice.id).c_str());
    if (clicked) run_command(ctx, spec, {choice.id});
  }
  ImGui::EndMenu();
}

void menu_item(PanelContext& ctx, const CommandSpec& spec) {
  const std::string reason = spec.reason_against(), keys = spec.shortcuts_text();
  const Parameter* const needed = spec.first_required();
  const bool one_required =
      std::all_of(spec.parameters.begin(), spec.parameters.end(),
                  [&](const Parameter& p) { return &p == needed || p.optional; });
  if (needed && needed->kind == Parameter::Kind::choice && one_required) {
    choice_menu(ctx, spec, *needed, reason.empty());
    return;
  }
  const bool checked = spec.checked && spec.checked();
  const bool clicked = ImGui::MenuItem(spec.title.c_str(), keys.c_str(), checked, reason.empty());
  record(ctx, ("menu." + spec.id).c_str());
  tooltip(ctx, (reason.empty() ? spec.help + "." : reason).c_str());
  if (clicked && needed) ctx.state.palette = {.show = true, .asking = spec.id};
  if (clicked && !needed) run_command(ctx, spec);
}

// Draws a menu. Returns whether it is open.
bool menu(PanelContext& ctx, std::string_view title) {
  std::vector<const CommandSpec*> specs;
  for (const CommandSpec& spec : ctx.commands.all()) {
    if (spec.menu == title) specs.push_back(&spec);
  }
  if (specs.empty()) return false;
  const std::string label(title);
  const bool open = ImGui::BeginMenu(label.c_str());
  record(ctx, ("menu." + label).c_str());
  if (!open) return false;
  close_on_escape();
  for (const CommandSpec* spec : specs) {
    if (spec->line_above && spec != specs.front()) ImGui::Separator();
    menu_item(ctx, *spec);
  }
  ImGui::EndMenu();
  return true;
}

// F10 opens the first menu. Left and Right lead from the open menu to its neighbour, and around the
// ends.
void open_by_key(PanelContext& ctx) {
  KeyState& keys = ctx.state.keys;
  constexpr int kCount = static_cast<int>(kMenus.size());
  int wanted = std::exchange(keys.open_menu, false) ? 0 : -1;
  if (keys.bar_menu >= 0 && !keys.in_submenu) {
    if (ImGui::IsKeyPressed(key::kRight)) wanted = (keys.bar_menu + 1) % kCount;
    if (ImGui::IsKeyPressed(key::kLeft)) wanted = (keys.bar_menu + kCount - 1) % kCount;
  }
  if (wanted < 0) return;
  ImGui::OpenPopup(std::string(kMenus[static_cast<std::size_t>(wanted)]).c_str());
  keys.mark_list = true;
}

bool pressed(const Shortcut& shortcut) {
  const auto chord = key::read_chord(shortcut.keys);
  return chord && key::pressed(*chord);
}

// A slider with the keyboard focus takes the arrow keys. A text that is read takes those that
// scroll it, and Escape.
bool taken_by_focus(const PanelContext& ctx, const Shortcut& shortcut) {
  const KeyState& keys = ctx.state.keys;
  if (keys.slid.empty() && !keys.reading) return false;
  const auto chord = key::read_chord(shortcut.keys);
  if (!chord || chord->control) return false;
  if (chord->arrow()) return true;
  const bool scrolls = chord->code >= key::kPageUp && chord->code <= key::kEnd;
  return keys.reading && (scrolls || chord->code == key::kEscape);
}

// Runs the command that takes the pressed key before all others. Returns whether there is one.
bool keys_before_others(PanelContext& ctx) {
  for (const CommandSpec& spec : ctx.commands.all()) {
    for (const Shortcut& shortcut : spec.keys_before_others) {
      const bool runs = pressed(shortcut) && !taken_by_focus(ctx, shortcut);
      if (!runs || !spec.reason_against().empty()) continue;
      run_command(ctx, spec, Commands::parse_words(spec, shortcut.arguments).words);
      return true;
    }
  }
  return false;
}

void shortcuts(PanelContext& ctx) {
  // At Escape ImGui closes a list before the frame is drawn. The key then belongs to that list.
  const bool popup = ctx.state.keys.list_open || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  const bool taken = ImGui::GetIO().WantTextInput || popup;
  if (!taken && keys_before_others(ctx)) return;
  for (const CommandSpec& spec : ctx.commands.all()) {
    if (taken && !spec.works_everywhere) continue;
    for (const Shortcut& shortcut : spec.shortcuts) {
      if (!pressed(shortcut) || taken_by_focus(ctx, shortcut)) continue;
      run_command(ctx, spec, Commands::parse_words(spec, shortcut.arguments).words);
    }
  }
}

}  // namespace

void draw_menu_bar(PanelContext& ctx) {
  shortcuts(ctx);
  if (!ImGui::BeginMainMenuBar()) return;
  open_by_key(ctx);
  KeyState& keys = ctx.state.keys;
  keys.bar_menu = -1;
  keys.in_submenu = false;
  for (std::size_t n = 0; n < kMenus.size(); ++n) {
    if (menu(ctx, kMenus[n])) keys.bar_menu = static_cast<int>(n);
  }
  ImGui::EndMainMenuBar();
}

}  // namespace alphascope
