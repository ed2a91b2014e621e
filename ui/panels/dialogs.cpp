// Error, cheat sheet, about, and saving a picture.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdio>

#include "ui/panels/format.hpp"
#include "ui/panels/keys.hpp"
#include "ui/panels/number_field.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

constexpr ImGuiWindowFlags kModalFlags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_AlwaysAutoResize;

// Peak memory of the whole window with an assembly's complex at alpha 0 on the CPU engine, per
// atom: 890 bytes for 1M4X' assembly 4 (1.6 million atoms), 1,190 for 3J6R's (1.0 million).
constexpr std::uint64_t kBytesPerAtomShown = 1200;

bool begin_modal(PanelContext& ctx, const char* title, bool wanted) {
  if (wanted && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  if (!wanted) return false;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  (void)ctx;
  return ImGui::BeginPopupModal(title, nullptr, kModalFlags);
}

bool dismissed_by_key() {
  return ImGui::IsKeyPressed(key::kEscape, false) || ImGui::IsKeyPressed(key::kEnter, false) ||
         ImGui::IsKeyPressed(key::kKeypadEnter, false);
}

void error_dialog(PanelContext& ctx) {
  std::string& error = ctx.state.error;
  if (!begin_modal(ctx, "That did not work", !error.empty())) return;
  ImGui::Dummy({ctx.px(420), 0});
  ImGui::PushTextWrapPos(ctx.px(440));
  ImGui::TextUnformatted(error.c_str());
  ImGui::PopTextWrapPos();
  if (ctx.state.molecule.loaded) {
    ImGui::Spacing();
    muted_text(ctx, "The molecule that was open before still is.");
  }
  ImGui::Dummy({0, ctx.px(6)});
  if (button(ctx, "error.copy", "Copy text", {ctx.px(100), 0})) {
    ImGui::SetClipboardText(error.c_str());
  }
  ImGui::SameLine(ctx.px(440) - ctx.px(90));
  if (button(ctx, "error.ok", "OK", {ctx.px(100), 0}, ButtonKind::primary) || dismissed_by_key()) {
    error.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void shortcut_rows(PanelContext& ctx, const char* title,
                   std::initializer_list<std::pair<const char*, const char*>> rows) {
  strong_text(ctx, title);
  if (!ImGui::BeginTable(title, 2)) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, ctx.px(190));
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, ctx.px(270));
  for (const auto& [keys, what] : rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys);
    ImGui::TableNextColumn();
    muted_text(ctx, what);
  }
  ImGui::EndTable();
  ImGui::Dummy({0, ctx.px(4)});
}

void cheat_sheet(PanelContext& ctx) {
  bool& show = ctx.state.memory.show_cheat_sheet;
  if (!begin_modal(ctx, "Mouse and keyboard", show)) return;
  shortcut_rows(ctx, "View",
                {{"drag", "turn"},
                 {"middle drag, shift + drag", "shift"},
                 {"wheel, right drag", "zoom"},
                 {"rest on a ball", "its name, place and radii"},
                 {"R", "reset the view"},
                 {"B, T, E", "balls, tetrahedra, edges on and off"},
                 {"Ctrl + L", "light or dark"}});
  shortcut_rows(ctx, "Alpha",
                {{"← →", "alpha − and + 0.1 Å²"},
                 {"shift + ← →", "alpha − and + 1 Å²"},
                 {"Ctrl + click on a slider", "type the value"},
                 {"C", "compare with CGAL"},
                 {"Esc", "close a menu; stop playing; cancel"}});
  shortcut_rows(ctx, "File",
                {{"Ctrl + O, or drop a file", "open a molecule"},
                 {"Ctrl + S", "save a picture"},
                 {"Ctrl + Q", "quit"},
                 {"F1", "this page"}});
  if (button(ctx, "cheat_sheet.close", "Close", {ctx.px(100), 0}, ButtonKind::primary) ||
      dismissed_by_key()) {
    show = false;
  }
  if (!show) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void about(PanelContext& ctx) {
  bool& show = ctx.state.memory.show_about;
  if (!begin_modal(ctx, "About Alphascope", show)) return;
  ImGui::PushFont(ctx.fonts.large);
  ImGui::TextUnformatted(("Alphascope " + ctx.state.version).c_str());
  ImGui::PopFont();
  ImGui::PushTextWrapPos(ctx.px(440));
  ImGui::TextUnformatted(
      "The exact alpha complex of a molecule, recomputed as you move alpha, and compared with CGAL "
      "simplex by simplex.");
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  muted_text(ctx, "Free software under the GNU GPL, version 3 or later.");
  muted_text(ctx, "Built on CGAL, VTK, Dear ImGui, GLFW, oneTBB and gemmi.");
  ImGui::Dummy({ctx.px(440), ctx.px(6)});
  if (button(ctx, "about.close", "Close", {ctx.px(100), 0}, ButtonKind::primary) ||
      dismissed_by_key()) {
    show = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void assembly_facts(PanelContext& ctx, const AssemblyRow& a) {
  const auto number = [](std::uint64_t n) { return with_separators(static_cast<long long>(n)); };
  const auto bytes = [](std::uint64_t n) { return bytes_text(static_cast<std::size_t>(n)); };
  const auto fact = [&ctx](const char* what, const std::string& value) {
    muted_text(ctx, what);
    ImGui::SameLine(ctx.px(250));
    ImGui::TextUnformatted(value.c_str());
  };
  const std::uint64_t all = a.atoms * kBytesPerAtomShown, free = ctx.state.free_bytes;
  fact("Assembly", a.id + (a.details.empty() ? "" : " (" + a.details + ")"));
  fact("Copies", number(a.copies));
  fact("Atoms", number(a.atoms));
  fact("Memory for the atoms", "about " + bytes(a.bytes));
  fact("With complex and picture", "about " + bytes(all));
  if (free > 0) fact("Free on this machine", bytes(free));
  if (free == 0 || all <= free) return;
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
  wrapped_text("That may not be enough: the system may end the program.");
  ImGui::PopStyleColor();
  record(ctx, "assembly.too_large");
}

void confirm_assembly(PanelContext& ctx) {
  ViewState& s = ctx.state;
  std::string& id = s.memory.confirm_assembly;
  const auto& list = s.molecule.assemblies;
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const AssemblyRow& a) { return a.id == id; });
  if (found == list.end()) id.clear();
  if (!begin_modal(ctx, "Expand a large assembly?", !id.empty())) return;
  ImGui::Dummy({ctx.px(440), 0});
  assembly_facts(ctx, *found);
  ImGui::Dummy({0, ctx.px(6)});
  muted_wrapped(ctx,
                "Expanding and computing can be cancelled; until the copies are made, the present "
                "molecule stays.");
  ImGui::Dummy({0, ctx.px(6)});
  const bool expand =
      button(ctx, "assembly.expand", "Expand", {ctx.px(100), 0}, ButtonKind::primary);
  ImGui::SameLine();
  const bool cancel = button(ctx, "assembly.cancel", "Cancel", {ctx.px(100), 0}) ||
                      ImGui::IsKeyPressed(key::kEscape, false);
  if (expand) s.selection.assembly = id;
  if (expand || cancel) {
    id.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void size_preset(PanelContext& ctx, const char* name, const char* label, int width, int height) {
  if (button(ctx, name, label)) {
    ctx.state.memory.save_width = width;
    ctx.state.memory.save_height = height;
  }
  ImGui::SameLine(0, ctx.px(4));
}

void save_size(PanelContext& ctx) {
  PanelMemory& m = ctx.state.memory;
  row_label(ctx, "Size");
  ImGui::SetNextItemWidth(ctx.px(80));
  number_field(ctx, "save.width", m.save_width, kPictureSizeRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("×");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(80));
  number_field(ctx, "save.height", m.save_height, kPictureSizeRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("pixels");
  row_label(ctx, "");
  size_preset(ctx, "save.as_view", "as the view", ctx.state.viewport.width,
              ctx.state.viewport.height);
  size_preset(ctx, "save.hd", "1920 × 1080", 1920, 1080);
  size_preset(ctx, "save.4k", "3840 × 2160", 3840, 2160);
  ImGui::NewLine();
}

// Pictures are PNG files whatever one calls them.
std::filesystem::path picture_path(const PanelMemory& m) {
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(m.save_path, ignored).lexically_normal();
  const std::string extension = path.extension().string();
  if (extension != ".png" && extension != ".PNG") path += ".png";
  return path;
}

// Where it will be, whatever folder the program was started in, and what becomes of what is there.
void save_target(PanelContext& ctx) {
  std::error_code ignored;
  const std::filesystem::path path = picture_path(ctx.state.memory);
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  if (std::filesystem::is_regular_file(path, ignored)) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
    ImGui::TextUnformatted("This file is there already and will be replaced.");
    ImGui::PopStyleColor();
    record(ctx, "save.replaces");
  } else if (!std::filesystem::is_directory(path.parent_path(), ignored)) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    ImGui::TextUnformatted(
        fitted_text("There is no folder " + path.parent_path().string(), ctx.px(340)).c_str());
    ImGui::PopStyleColor();
    record(ctx, "save.no_folder");
  } else {
    muted_text(ctx, fitted_text(path.string(), ctx.px(340)));
    tooltip(ctx, path.string().c_str());
  }
  ImGui::PopFont();
}

// What is drawn over the molecule.
void save_marks(PanelContext& ctx) {
  PanelMemory& m = ctx.state.memory;
  const bool has_legend = ctx.state.viewport.legend.has_value();
  row_label(ctx, "With");
  ImGui::BeginDisabled(!has_legend);
  bool legend = has_legend && m.save_legend;
  if (checkbox(ctx, "save.legend", "Colour legend", legend)) m.save_legend = legend;
  ImGui::EndDisabled();
  tooltip(ctx, has_legend ? "What the colours say: alpha values in Å²."
                          : "There is one when the complex is coloured by alpha value.");
  ImGui::SameLine(0, ctx.px(18));
  checkbox(ctx, "save.scale_bar", "Scale bar", m.save_scale_bar);
  tooltip(ctx,
          "A round length in Å. The view is in perspective: it holds at the depth of the point "
          "that the view turns about.");
}

void save_picture(PanelContext& ctx) {
  ViewState& s = ctx.state;
  PanelMemory& m = s.memory;
  if (m.show_save && m.save_path.empty()) m.save_path = "alphascope.png";
  if (!begin_modal(ctx, "Save a picture", m.show_save)) return;
  row_label(ctx, "File");
  ImGui::SetNextItemWidth(ctx.px(340));
  const bool entered =
      ImGui::InputText("##path", &m.save_path, ImGuiInputTextFlags_EnterReturnsTrue);
  record(ctx, "save.path");
  save_target(ctx);
  save_size(ctx);
  row_label(ctx, "");
  checkbox(ctx, "save.transparent", "Transparent background", m.save_transparent);
  save_marks(ctx);
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  muted_text(ctx, "File, selection, radii, alpha and hash are written into the picture.");
  ImGui::PopFont();
  ImGui::Dummy({0, ctx.px(6)});
  if (button(ctx, "save.cancel", "Cancel", {ctx.px(100), 0}) ||
      ImGui::IsKeyPressed(key::kEscape, false)) {
    m.show_save = false;
  }
  ImGui::SameLine(ctx.px(364));
  ImGui::BeginDisabled(m.save_path.empty());
  if (button(ctx, "save.ok", "Save", {ctx.px(100), 0}, ButtonKind::primary) ||
      (entered && !m.save_path.empty())) {
    s.requests.screenshot = {picture_path(m),    m.save_width,  m.save_height,
                             m.save_transparent, m.save_legend, m.save_scale_bar};
    m.show_save = false;
  }
  ImGui::EndDisabled();
  if (!m.show_save) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace

void draw_dialogs(PanelContext& ctx) {
  cheat_sheet(ctx);
  about(ctx);
  save_picture(ctx);
  confirm_assembly(ctx);
  error_dialog(ctx);
}

}  // namespace alphascope
