// The menu bar and the keyboard shortcuts, both made from the list of commands.
#include "ui/panels/keys.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

// A refusal is no news: the menu greys what cannot run.
void run(PanelContext& ctx, const CommandSpec& spec, const std::vector<std::string>& words = {}) {
  const Outcome outcome = ctx.commands.run(spec.id, words);
  if (outcome.state == Outcome::State::failed) {
    ctx.state.tell("“" + spec.title + "” did not work", outcome.why);
  }
}

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
    if (clicked) run(ctx, spec, {choice.id});
  }
  ImGui::EndMenu();
}

void menu_item(PanelContext& ctx, const CommandSpec& spec) {
  const std::string reason = spec.reason_against(), keys = spec.shortcuts_text();
  const Parameter* const needed = spec.first_required();
  if (needed && needed->kind == Parameter::Kind::choice && spec.parameters.size() == 1) {
    choice_menu(ctx, spec, *needed, reason.empty());
    return;
  }
  const bool checked = spec.checked && spec.checked();
  const bool clicked = ImGui::MenuItem(spec.title.c_str(), keys.c_str(), checked, reason.empty());
  record(ctx, ("menu." + spec.id).c_str());
  tooltip(ctx, (reason.empty() ? spec.help + "." : reason).c_str());
  if (clicked && needed) ctx.state.memory.palette = {.show = true, .asking = spec.id};
  if (clicked && !needed) run(ctx, spec);
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

void shortcuts(PanelContext& ctx) {
  const bool taken =
      ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  for (const CommandSpec& spec : ctx.commands.all()) {
    if (taken && !spec.works_everywhere) continue;
    for (const Shortcut& shortcut : spec.shortcuts) {
      const auto chord = key::read_chord(shortcut.keys);
      if (!chord || !key::pressed(*chord)) continue;
      run(ctx, spec, Commands::parse_words(spec, shortcut.arguments).words);
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
