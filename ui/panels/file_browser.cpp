// The dialog for opening a molecule or a table of radii: folders and files that look like one, and
// a path to type.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "ui/panels/folder_listing.hpp"
#include "ui/panels/format.hpp"
#include "ui/panels/keys.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

bool for_table(const PanelMemory& m) {
  return m.browser_purpose == BrowserPurpose::radii_table;
}

const char* title(const PanelMemory& m) {
  return for_table(m) ? "Open a table of radii" : "Open a molecule";
}

void enter(PanelMemory& m, const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(folder, error);
  m.browser_folder = (error ? folder : absolute).lexically_normal();
  if (!m.browser_folder.has_filename() && m.browser_folder.has_parent_path() &&
      m.browser_folder != m.browser_folder.root_path()) {
    m.browser_folder = m.browser_folder.parent_path();  // no slash at the end
  }
  m.browser_typed = m.browser_folder.string();
  m.browser_selected.clear();
}

void open(ViewState& s, const fs::path& file) {
  if (for_table(s.memory)) {
    s.selection.radii_table = file.string();
    for (std::size_t i = 0; i < s.radii_sets.size(); ++i) {
      const bool table = s.radii_sets[i].kind == RadiiSetEntry::Kind::user_table;
      if (table) s.selection.radii_set = static_cast<int>(i);
    }
  } else {
    s.requests.open = file;
  }
  s.memory.show_browser = false;
  ImGui::CloseCurrentPopup();
}

// A typed path: a folder is entered, anything else is opened (the reader explains what is wrong).
void accept_typed(ViewState& s) {
  std::string text = s.memory.browser_typed;
  if (text.starts_with("~/")) {
    if (const char* home = std::getenv("HOME")) text = home + text.substr(1);
  }
  if (text.empty()) return;
  std::error_code error;
  if (fs::is_directory(text, error)) {
    enter(s.memory, text);
  } else {
    open(s, text);
  }
}

void path_row(PanelContext& ctx) {
  PanelMemory& m = ctx.state.memory;
  if (button(ctx, "browser.up", "Up")) enter(m, m.browser_folder.parent_path());
  tooltip(ctx, "The folder above");
  ImGui::SameLine();
  if (button(ctx, "browser.home", "Home")) {
    if (const char* home = std::getenv("HOME")) enter(m, home);
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##path", &m.browser_typed, ImGuiInputTextFlags_EnterReturnsTrue)) {
    accept_typed(ctx.state);
  }
  record(ctx, "browser.path");
}

void entry_row(PanelContext& ctx, const FolderEntry& entry) {
  ViewState& s = ctx.state;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = entry.folder ? entry.name + "/" : entry.name;
  if (ImGui::Selectable(label.c_str(), s.memory.browser_selected == entry.path,
                        ImGuiSelectableFlags_SpanAllColumns |
                            ImGuiSelectableFlags_AllowDoubleClick |
                            ImGuiSelectableFlags_DontClosePopups)) {
    if (entry.folder) {
      enter(s.memory, entry.path);
    } else {
      s.memory.browser_selected = entry.path;
      s.memory.browser_typed = entry.path.string();
      if (ImGui::IsMouseDoubleClicked(0)) open(s, entry.path);
    }
  }
  record(ctx, ("browser.entry." + entry.name).c_str());
  ImGui::TableNextColumn();
  if (!entry.folder) muted_text(ctx, bytes_text(entry.bytes));
}

void listing(PanelContext& ctx, float height) {
  PanelMemory& m = ctx.state.memory;
  // Read again in every frame in which the dialog is redrawn: cheap, and never out of date.
  const FolderListing list = list_folder(m.browser_folder, m.browser_all_files || for_table(m));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_imgui(ctx.palette.panel));
  ImGui::BeginChild("entries", {0, height}, true);
  if (!list.error.empty()) {
    ImGui::TextUnformatted(list.error.c_str());
  } else if (list.entries.empty()) {
    muted_wrapped(ctx, list.hidden_by_filter == 0
                           ? "This folder is empty."
                           : "No molecules here; " +
                                 with_separators(static_cast<long long>(list.hidden_by_filter)) +
                                 " other files are not shown.");
  } else if (ImGui::BeginTable("list", 2, ImGuiTableFlags_None)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ctx.px(80));
    for (const FolderEntry& entry : list.entries) entry_row(ctx, entry);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void buttons(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (for_table(s.memory)) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "Lines such as: C 1.70   ALA CB 1.88   * CB 1.88");
  } else {
    checkbox(ctx, "browser.all", "All files", s.memory.browser_all_files);
  }
  const float width = ctx.px(96);
  ImGui::SameLine(ImGui::GetWindowWidth() - 2 * width - ctx.px(20));
  if (button(ctx, "browser.cancel", "Cancel", {width, 0}) ||
      ImGui::IsKeyPressed(key::kEscape, false)) {
    s.memory.show_browser = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(s.memory.browser_typed.empty());
  if (button(ctx, "browser.open", "Open", {width, 0}, ButtonKind::primary)) accept_typed(s);
  ImGui::EndDisabled();
}

}  // namespace

void draw_file_browser(PanelContext& ctx) {
  PanelMemory& m = ctx.state.memory;
  if (!m.show_browser) return;
  if (!ImGui::IsPopupOpen(title(m))) {
    enter(m, m.browser_folder.empty() ? sensible_start_folder() : m.browser_folder);
    ImGui::OpenPopup(title(m));
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(ctx.px(640), display.x * 0.9f), std::min(ctx.px(480), display.y * 0.85f)});
  if (!ImGui::BeginPopupModal(
          title(m), nullptr,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    return;
  }
  path_row(ctx);
  const float bottom = ImGui::GetFrameHeightWithSpacing() + ctx.px(4);
  listing(ctx, ImGui::GetContentRegionAvail().y - bottom);
  buttons(ctx);
  ImGui::EndPopup();
}

}  // namespace alphascope
