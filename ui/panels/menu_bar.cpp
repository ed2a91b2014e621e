// The menu bar and the keyboard shortcuts, both made from the list of commands.
#include <algorithm>

#include "ui/panels/keys.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {

void run_command(PanelContext& ctx, const CommandSpec& spec,
                 const std::vector<std::string>& words) {
  const bool could = spec.reason_against().empty();
  const Outcome outcome = ctx.commands.run(spec.id, words);
  if (outcome.state == Outcome::State::failed) {
    ctx.state.tell("“" + spec.title + "” did not work", outcome.why);
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
  if (clicked && needed) ctx.state.memory.palette = {.show = true, .asking = spec.id};
  if (clicked && !needed) run_command(ctx, spec);
}

void menu(PanelContext& ctx, std::string_view title) {
  std::vector<const CommandSpec*> specs;
  for (const CommandSpec& spec : ctx.commands.all()) {
    if (spec.menu == title) specs.push_back(&spec);
  }
  if (specs.empty()) return;
  const std::string label(title);
  const bool open = ImGui::BeginMenu(label.c_str());
  record(ctx, ("menu." + label).c_str());
  if (!open) return;
  close_on_escape();
  for (const CommandSpec* spec : specs) {
    if (spec->line_above && spec != specs.front()) ImGui::Separator();
    menu_item(ctx, *spec);
  }
  ImGui::EndMenu();
}

bool pressed(const Shortcut& shortcut) {
  const auto chord = key::read_chord(shortcut.keys);
  return chord && key::pressed(*chord);
}

// True when a command took a key from others.
bool keys_before_others(PanelContext& ctx) {
  for (const CommandSpec& spec : ctx.commands.all()) {
    for (const Shortcut& shortcut : spec.keys_before_others) {
      if (!pressed(shortcut) || !spec.reason_against().empty()) continue;
      run_command(ctx, spec, Commands::parse_words(spec, shortcut.arguments).words);
      return true;
    }
  }
  return false;
}

void shortcuts(PanelContext& ctx) {
  const bool taken =
      ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (!taken && keys_before_others(ctx)) return;
  for (const CommandSpec& spec : ctx.commands.all()) {
    if (taken && !spec.works_everywhere) continue;
    for (const Shortcut& shortcut : spec.shortcuts) {
      if (!pressed(shortcut)) continue;
      run_command(ctx, spec, Commands::parse_words(spec, shortcut.arguments).words);
    }
  }
}

}  // namespace

void draw_menu_bar(PanelContext& ctx) {
  shortcuts(ctx);
  if (!ImGui::BeginMainMenuBar()) return;
  for (const std::string_view title : kMenus) menu(ctx, title);
  ImGui::EndMainMenuBar();
}

}  // namespace alphascope
