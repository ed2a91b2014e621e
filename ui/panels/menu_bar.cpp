// The menu bar and the keyboard shortcuts that mirror it.
#include <cmath>

#include "ui/panels/keys.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

bool menu_item(PanelContext& ctx, const char* name, const char* label, const char* shortcut,
               bool checked = false, bool enabled = true) {
  const bool clicked = ImGui::MenuItem(label, shortcut, checked, enabled);
  record(ctx, name);
  return clicked;
}

bool begin_menu(PanelContext& ctx, const char* name, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  record(ctx, name);
  if (open) close_on_escape();
  return open;
}

void toggle_theme(ViewState& s) {
  s.theme = s.theme == Theme::dark ? Theme::light : Theme::dark;
}

void file_menu(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (!begin_menu(ctx, "menu.file", "File")) return;
  if (menu_item(ctx, "menu.open", "Open…", "Ctrl + O")) open_browser(s);
  if (ImGui::BeginMenu("Sample molecule", !s.samples.empty())) {
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
      if (ImGui::MenuItem(s.samples[i].name.c_str(), s.samples[i].detail.c_str())) {
        s.requests.open_sample = i;
      }
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (menu_item(ctx, "menu.screenshot", "Save picture…", "Ctrl + S", false, s.molecule.loaded)) {
    s.memory.show_save = true;
  }
  ImGui::Separator();
  if (menu_item(ctx, "menu.quit", "Quit", "Ctrl + Q")) s.requests.quit = true;
  ImGui::EndMenu();
}

void view_menu(PanelContext& ctx) {
  ViewState& s = ctx.state;
  DisplayControls& d = s.display;
  if (!begin_menu(ctx, "menu.view", "View")) return;
  if (menu_item(ctx, "menu.reset", "Reset view", "R", false, s.molecule.loaded)) {
    s.requests.reset_view = true;
  }
  ImGui::Separator();
  if (menu_item(ctx, "menu.balls", "Balls", "B", d.balls)) d.balls = !d.balls;
  if (menu_item(ctx, "menu.tetrahedra", "Tetrahedra", "T", d.tetrahedra)) {
    d.tetrahedra = !d.tetrahedra;
  }
  if (menu_item(ctx, "menu.edges", "Edges", "E", d.edges)) d.edges = !d.edges;
  ImGui::Separator();
  if (menu_item(ctx, "menu.theme", "Light theme", "Ctrl + L", s.theme == Theme::light)) {
    toggle_theme(s);
  }
  ImGui::EndMenu();
}

void tools_menu(PanelContext& ctx) {
  if (!begin_menu(ctx, "menu.tools", "Tools")) return;
  if (menu_item(ctx, "menu.benchmark", "Benchmark…", nullptr, false, ctx.state.molecule.loaded)) {
    ctx.state.memory.playing = ctx.state.memory.playing_models = false;
    ctx.state.memory.show_benchmark = true;
  }
  ImGui::EndMenu();
}

void help_menu(PanelContext& ctx) {
  if (!begin_menu(ctx, "menu.help", "Help")) return;
  if (menu_item(ctx, "menu.cheat_sheet", "Mouse and keyboard", "F1")) {
    ctx.state.memory.show_cheat_sheet = true;
  }
  if (menu_item(ctx, "menu.about", "About Alphascope", nullptr)) ctx.state.memory.show_about = true;
  ImGui::EndMenu();
}

void step_alpha(ViewState& s, double step) {
  set_alpha(s.compute, std::round((s.compute.alpha_angstrom2 + step) * 1000) / 1000);
}

// The step at hand still finishes when something plays: a picture without its complex helps nobody.
void stop(ViewState& s) {
  const bool playing = s.memory.playing || s.memory.playing_models;
  s.memory.playing = s.memory.playing_models = false;
  if (!playing && s.busy.active) s.requests.cancel = true;
}

void shortcuts(ViewState& s) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsKeyPressed(key::kF1, false)) s.memory.show_cheat_sheet = !s.memory.show_cheat_sheet;
  if (io.WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
  if (io.KeyCtrl) {
    if (ImGui::IsKeyPressed(key::kO, false)) open_browser(s);
    if (ImGui::IsKeyPressed(key::kS, false) && s.molecule.loaded) s.memory.show_save = true;
    if (ImGui::IsKeyPressed(key::kL, false)) toggle_theme(s);
    if (ImGui::IsKeyPressed(key::kQ, false)) s.requests.quit = true;
    return;
  }
  if (ImGui::IsKeyPressed(key::kEscape, false)) stop(s);
  if (ImGui::IsKeyPressed(key::kR, false)) s.requests.reset_view = true;
  if (ImGui::IsKeyPressed(key::kC, false) && s.result.present) s.requests.compare = true;
  if (ImGui::IsKeyPressed(key::kB, false)) s.display.balls = !s.display.balls;
  if (ImGui::IsKeyPressed(key::kT, false)) s.display.tetrahedra = !s.display.tetrahedra;
  if (ImGui::IsKeyPressed(key::kE, false)) s.display.edges = !s.display.edges;
  const double step = io.KeyShift ? 1.0 : 0.1;
  if (ImGui::IsKeyPressed(key::kRight)) step_alpha(s, step);
  if (ImGui::IsKeyPressed(key::kLeft)) step_alpha(s, -step);
}

}  // namespace

void draw_menu_bar(PanelContext& ctx) {
  shortcuts(ctx.state);
  if (!ImGui::BeginMainMenuBar()) return;
  file_menu(ctx);
  view_menu(ctx);
  tools_menu(ctx);
  help_menu(ctx);
  ImGui::EndMainMenuBar();
}

}  // namespace alphascope
