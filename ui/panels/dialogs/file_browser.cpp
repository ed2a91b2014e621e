// SPDX-License-Identifier: GPL-3.0-or-later
// The file dialog: opens a molecule, a session or a table of radii, or finds a place to save to. It
// lists folders and suitable files, and has a field for a path.
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/document/settings/open_options.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/radii/radii_choice.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/folder_listing.hpp"
#include "ui/panels/dialogs/save_state.hpp"
#include "ui/panels/dialogs/session_problem.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

bool for_table(const BrowserState& m) {
  return m.purpose == BrowserPurpose::radii_table;
}

constexpr int kListKeys[] = {key::kHome, key::kEnd,      key::kDown,
                             key::kUp,   key::kPageDown, key::kPageUp};

const char* title(const BrowserState& m) {
  switch (m.purpose) {
    case BrowserPurpose::radii_table:
      return "Open a table of radii";
    case BrowserPurpose::session:
      return "Open a session";
    case BrowserPurpose::session_molecule:
      return "The molecule of the session";
    case BrowserPurpose::save:
      return "Where to save";
    case BrowserPurpose::molecule:
      break;
  }
  return "Open a molecule";
}

// Returns the absolute path, without a slash at the end.
fs::path as_folder(const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(folder, error);
  const fs::path normal = (error ? folder : absolute).lexically_normal();
  const bool slash = !normal.has_filename() && normal.has_parent_path();
  return slash && normal != normal.root_path() ? normal.parent_path() : normal;
}

void enter(BrowserState& m, const fs::path& folder) {
  m.folder = m.base = as_folder(folder);
  m.typed = m.folder.string();
  m.by_hand = false;
  m.begun.clear();
  m.selected.clear();
  m.error.clear();
  m.jump.clear();
}

// Enters the parent folder. The folder left behind is chosen there, so that Enter leads back.
void enter_above(BrowserState& m) {
  const fs::path from = m.folder;
  enter(m, from.parent_path());
  if (m.folder == from) return;
  m.selected = from;
  m.scroll = true;
}

void select(BrowserState& m, const FolderEntry& entry) {
  m.selected = entry.path;
  m.typed = entry.path.string();
  m.by_hand = false;
  m.begun.clear();
  m.error.clear();
}

bool for_saving(const BrowserState& m) {
  return m.purpose == BrowserPurpose::save;
}

void close(ViewState& s) {
  s.browser.show = false;
  if (for_saving(s.browser)) s.browser.folder = s.saving.opens_from;
}

// Hands the path to the dialog that saves. If it is a folder, the file name in that dialog stays.
void save_there(ViewState& s, const fs::path& path) {
  std::error_code ignored;
  const bool folder = fs::is_directory(path, ignored);
  if (!folder && !fs::is_directory(path.parent_path(), ignored)) {
    s.browser.error = "There is no folder " + path.parent_path().string() + ".";
    return;
  }
  s.saving.found = folder ? path / s.saving.found.filename() : path;
  s.saving.found_for = s.saving.browses_for;
  close(s);
}

// Opens the file. If it cannot be opened, the dialog stays and says why.
void open(PanelContext& ctx, const fs::path& file) {
  ViewState& s = ctx.state;
  if (for_saving(s.browser)) return save_there(s, file);
  s.browser.error = why_not_openable(file);
  if (!s.browser.error.empty()) return;
  if (for_table(s.browser)) {
    s.settings.open.radii_table = file;
    s.settings.open.balls.radii = RadiiSet::user;
  } else if (s.browser.purpose == BrowserPurpose::session_molecule) {
    ctx.calls.files.continue_session(file);
    s.session_problem.reset();
  } else if (s.browser.purpose == BrowserPurpose::session) {
    ctx.calls.files.open_session(file);
  } else {
    ctx.calls.files.open(file);
  }
  close(s);
}

// Enters a folder, and opens anything else.
void accept(PanelContext& ctx, const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    enter(ctx.state.browser, path);
  } else {
    open(ctx, path);
  }
}

// Returns the whole path; empty if nothing is typed.
fs::path browsed_path(const BrowserState& m) {
  return typed_path(m.typed, m.base);
}

void accept_typed(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const fs::path path = browsed_path(s.browser);
  if (path.empty()) return;
  // The folder on show is taken as the place, since entering it would do nothing.
  if (for_saving(s.browser) && as_folder(path) == s.browser.folder) {
    return save_there(s, s.browser.folder);
  }
  accept(ctx, path);
}

// Follows a path that is being typed. It lists the last folder in the path, and chooses the first
// entry that begins with the rest.
void follow_typed(BrowserState& m) {
  m.by_hand = true;
  m.error.clear();
  m.selected.clear();
  const fs::path path = browsed_path(m);
  if (path.empty()) return;
  const fs::path folder = as_folder(path.parent_path());
  m.begun = path.filename().string();
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) {
    m.folder = folder;
  } else {
    m.error = "There is no folder " + folder.string() + ".";
  }
}

void path_row(PanelContext& ctx) {
  BrowserState& m = ctx.state.browser;
  if (button(ctx, "browser.up", "Up")) enter_above(m);
  tooltip(ctx, "The folder above (Backspace)");
  ImGui::SameLine();
  if (button(ctx, "browser.home", "Home")) {
    if (const char* home = std::getenv("HOME")) enter(m, home);
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  const bool entered = text_field(ctx, "browser.path", m.typed, "", KeyStop::type_when_asked);
  if (ImGui::IsItemEdited()) follow_typed(m);
  if (entered) accept_typed(ctx);
}

void entry_row(PanelContext& ctx, const FolderEntry& entry) {
  ViewState& s = ctx.state;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = entry.folder ? entry.name + "/" : entry.name;
  if (ImGui::Selectable(label.c_str(), s.browser.selected == entry.path,
                        ImGuiSelectableFlags_SpanAllColumns |
                            ImGuiSelectableFlags_AllowDoubleClick |
                            ImGuiSelectableFlags_DontClosePopups)) {
    if (entry.folder) {
      enter(s.browser, fs::path(entry.path));
    } else {
      select(s.browser, entry);
      if (ImGui::IsMouseDoubleClicked(0)) open(ctx, entry.path);
    }
  }
  record(ctx, ("browser.entry." + entry.name).c_str());
  ImGui::TableNextColumn();
  if (!entry.folder) muted_text(ctx, file_size_text(entry.bytes));
}

std::size_t selected_index(const BrowserState& m, const FolderListing& list) {
  const auto found = std::find_if(list.entries.begin(), list.entries.end(),
                                  [&m](const FolderEntry& e) { return e.path == m.selected; });
  return static_cast<std::size_t>(found - list.entries.begin());
}

// Returns the entry to which the pressed arrow or page key leads; `now` if none is pressed.
std::size_t key_target(std::size_t now, std::size_t count, std::size_t page) {
  const auto pressed = [](int code) { return ImGui::IsKeyPressed(code); };
  const std::size_t last = count - 1;
  const bool none = now == count;
  if (pressed(key::kHome)) return 0;
  if (pressed(key::kEnd)) return last;
  if (pressed(key::kDown)) return none ? 0 : std::min(now + 1, last);
  if (pressed(key::kUp)) return none ? last : now - std::min<std::size_t>(now, 1);
  if (pressed(key::kPageDown)) return none ? 0 : std::min(now + page, last);
  if (pressed(key::kPageUp)) return none ? 0 : now - std::min(now, page);
  return now;
}

// Returns the entry whose name begins with the typed letters. Letters typed in quick succession
// make one beginning.
std::size_t jump_target(BrowserState& m, const FolderListing& list, std::size_t now) {
  constexpr double kPauseSeconds = 1;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.InputQueueCharacters.empty() || io.KeyCtrl) return now;
  if (ImGui::GetTime() - m.jump_seconds > kPauseSeconds) m.jump.clear();
  for (const ImWchar c : io.InputQueueCharacters) {
    if (c > 32 && c < 127) m.jump += static_cast<char>(c);
  }
  m.jump_seconds = ImGui::GetTime();
  if (m.jump.empty()) return now;
  // A single letter is looked for behind the chosen entry, so the same letter after a pause leads
  // to the next name.
  const bool on = m.jump.size() == 1 && now < list.entries.size();
  const std::size_t found = find_entry(list, m.jump, on ? now + 1 : 0);
  return found < list.entries.size() ? found : now;
}

// Up and Down lead from the path into the list. Returns whether no text is being typed any more.
bool leaves_path(const PanelContext& ctx) {
  if (!ImGui::IsAnyItemActive()) return true;
  constexpr int kInto[] = {key::kDown, key::kUp, key::kPageDown, key::kPageUp};
  const bool leaves = ctx.state.keys.at.back().name == "browser.path" &&
                      std::any_of(std::begin(kInto), std::end(kInto),
                                  [](int code) { return ImGui::IsKeyPressed(code); });
  if (leaves) stop_typing();
  return leaves;
}

// Puts pasted text, and text that begins with / or ~, into the field for the path. Other letters
// jump to a name.
void begin_path(PanelContext& ctx) {
  BrowserState& m = ctx.state.browser;
  const ImGuiIO& io = ImGui::GetIO();
  if (!on_top(ctx) || ctx.state.keys.list_open || ctx.state.keys.begins || ImGui::IsAnyItemActive())
    return;
  std::string begun;
  if (io.KeyCtrl && ImGui::IsKeyPressed(key::kV, false)) {
    const char* const pasted = ImGui::GetClipboardText();
    begun = pasted == nullptr ? "" : pasted;
    std::erase_if(begun, [](unsigned char c) { return c < 32; });
  } else if (!io.KeyCtrl && !io.InputQueueCharacters.empty()) {
    const ImWchar first = io.InputQueueCharacters[0];
    if (first != '/' && first != '~') return;
    for (const ImWchar c : io.InputQueueCharacters) {
      if (c >= 32 && c < 127) begun += static_cast<char>(c);
    }
  }
  if (begun.empty()) return;
  m.typed = begun;
  follow_typed(m);
  type_into(ctx, "browser.path");
}

// Handles keys for the list, while nothing is typed and no dialog is above. Returns whether another
// folder is shown now.
bool keyboard(PanelContext& ctx, const FolderListing& list, std::size_t page) {
  BrowserState& m = ctx.state.browser;
  if (!on_top(ctx) || ctx.state.keys.list_open || ctx.state.keys.begins || !leaves_path(ctx))
    return false;
  if (ImGui::IsKeyPressed(key::kBackspace)) {
    enter_above(m);
    return true;
  }
  if (list.entries.empty()) return false;
  const bool enter = enter_pressed(ctx) && !m.by_hand;
  const bool any = !ImGui::GetIO().InputQueueCharacters.empty() || enter ||
                   std::any_of(std::begin(kListKeys), std::end(kListKeys),
                               [](int code) { return ImGui::IsKeyPressed(code); });
  if (!any) return false;
  const std::size_t count = list.entries.size(), now = selected_index(m, list);
  if (enter && now < count) {
    ctx.state.keys.enter_used = true;
    accept(ctx, fs::path(list.entries[now].path));
    return true;
  }
  const std::size_t target = jump_target(m, list, key_target(now, count, page));
  if (target == now || target >= count) return false;
  select(m, list.entries[target]);
  m.scroll = true;
  return false;
}

// Chooses the first entry whose name begins like the typed text. The typed path stays.
void choose_begun(BrowserState& m, const FolderListing& list) {
  const std::string begun = std::exchange(m.begun, {});
  if (begun.empty()) return;
  const std::size_t found = find_entry(list, begun, 0);
  if (found == list.entries.size()) return;
  m.selected = list.entries[found].path;
  m.scroll = true;
}

// Scrolls to the chosen entry, if a key has chosen it.
void scroll_to_selected(BrowserState& m, const FolderListing& list, float row) {
  if (!std::exchange(m.scroll, false)) return;
  const std::size_t index = selected_index(m, list);
  if (index == list.entries.size()) return;
  const float top = static_cast<float>(index) * row, height = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
  if (top + 2 * row > ImGui::GetScrollY() + height) ImGui::SetScrollY(top + 2 * row - height);
}

// Draws only the rows in sight, since a folder can have many thousands.
void entries(PanelContext& ctx, const std::shared_ptr<const FolderListing>& list) {
  const float row = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float page = std::max(1.0f, ImGui::GetWindowHeight() / row - 2);
  if (keyboard(ctx, *list, static_cast<std::size_t>(page))) return;
  choose_begun(ctx.state.browser, *list);
  scroll_to_selected(ctx.state.browser, *list, row);
  if (!ImGui::BeginTable("list", 2, ImGuiTableFlags_None)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ctx.px(80));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(list->entries.size()), row);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      entry_row(ctx, list->entries[static_cast<std::size_t>(i)]);
    }
  }
  ImGui::EndTable();
}

std::string nothing_listed(const FolderListing& list) {
  if (!list.error.empty()) return list.error;
  if (list.hidden_by_filter == 0) return "This folder is empty.";
  return (list.query.sessions ? "No sessions here; " : "No molecules here; ") +
         counted(list.hidden_by_filter, "other file is", "other files are") + " not shown.";
}

void listing(PanelContext& ctx, float height) {
  const BrowserState& m = ctx.state.browser;
  const auto list = ctx.state.listing;  // keeps the listing alive for this frame
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_imgui(ctx.palette.panel));
  // Each folder has a scroll position of its own.
  ImGui::BeginChild(("entries" + m.folder.string()).c_str(), {0, height}, true);
  if (!list || list->query != wanted_listing(m)) {
    muted_text(ctx, "Reading this folder…");
    record(ctx, "browser.reading");
  } else if (!list->error.empty() || list->entries.empty()) {
    muted_wrapped(ctx, nothing_listed(*list));
    if (list->error.empty()) keyboard(ctx, *list, 1);
  } else {
    entries(ctx, list);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

// Shows what is wrong with the path, else what keys do. It is always one line, so that nothing
// moves.
void message_row(PanelContext& ctx) {
  const BrowserState& m = ctx.state.browser;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(ctx.fonts.small);
  if (m.error.empty()) {
    muted_text(ctx, for_saving(m)
                        ? "Arrow keys and Enter: open a folder.  Choose: save here, or replace "
                          "the selected file."
                        : "Arrow keys: choose.  Enter: open.  Letters: jump to a name.  "
                          "/: type a path.");
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    ImGui::TextUnformatted(fitted_text(m.error, width).c_str());
    ImGui::PopStyleColor();
    record(ctx, "browser.error");
    tooltip(ctx, m.error.c_str());
  }
  ImGui::PopFont();
}

void buttons(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (for_saving(s.browser)) {
    checkbox(ctx, "browser.hidden", "Hidden files", s.browser.hidden_ones);
  } else if (for_table(s.browser)) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "Lines such as: C 1.70   ALA CB 1.88   * CB 1.88");
  } else {
    checkbox(ctx, "browser.all", "All files", s.browser.all_files);
    ImGui::SameLine(0, ctx.px(18));
    checkbox(ctx, "browser.hidden", "Hidden files", s.browser.hidden_ones);
    tooltip(ctx, "Files and folders whose names start with a dot.");
  }
  const float width = ImGui::GetWindowWidth() - 2 * ImGui::GetStyle().WindowPadding.x;
  const DialogAnswer answer = dialog_buttons(
      ctx, width, {"browser.cancel", "Cancel"},
      {"browser.open", for_saving(s.browser) ? "Choose" : "Open"}, !s.browser.typed.empty());
  if (answer == DialogAnswer::cancel) close(s);
  if (answer == DialogAnswer::confirm) accept_typed(ctx);
}

}  // namespace

std::optional<FolderQuery> wanted_listing(const BrowserState& m) {
  if (!m.show || m.folder.empty()) return std::nullopt;
  return FolderQuery{m.folder, m.all_files || for_table(m) || for_saving(m), m.hidden_ones,
                     m.purpose == BrowserPurpose::session};
}

void draw_file_browser(PanelContext& ctx) {
  BrowserState& m = ctx.state.browser;
  if (!ImGui::IsPopupOpen(title(m))) {
    enter(m, m.folder.empty() ? sensible_start_folder() : m.folder);
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 size{std::min(ctx.px(640), display.x * 0.9f),
                    std::min(ctx.px(480), display.y * 0.85f)};
  if (!begin_dialog(ctx, title(m), size)) return;
  path_row(ctx);
  begin_path(ctx);
  const float bottom = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  listing(ctx, ImGui::GetContentRegionAvail().y - bottom - ctx.px(4));
  message_row(ctx);
  buttons(ctx);
  end_dialog(ctx);
}

}  // namespace alphascope
