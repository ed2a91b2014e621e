// SPDX-License-Identifier: GPL-3.0-or-later
// The row for a file's path, its proposal, and the notes on whether and where it can be written.
#include "ui/panels/dialogs/save_target.hpp"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "core/document/fetch/fetch.hpp"
#include "core/files/atomic_file.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/save_state.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr float kTextWidth = 340;  // pixels at scale 1

// Returns the folder to propose. Folders of samples and of fetched files belong to the program, so
// they are not proposed.
fs::path folder_to_offer(const ViewState& s) {
  std::error_code ignored;
  if (fs::is_directory(s.saving.folder, ignored)) return s.saving.folder;
  const fs::path beside = fs::absolute(s.molecule.folder, ignored).lexically_normal();
  const bool sample = std::any_of(s.samples.begin(), s.samples.end(), [&](const auto& one) {
    return fs::equivalent(one.path.parent_path(), beside, ignored);
  });
  const bool fetched = id_of_fetched(beside / s.molecule.name).has_value();
  if (!sample && !fetched && fs::is_directory(beside, ignored) &&
      access(beside.c_str(), W_OK) == 0) {
    return beside;
  }
  return fs::current_path(ignored);
}

std::string why_no_name(const fs::path& path) {
  std::error_code ignored;
  if (path.empty()) return "Give the file a name.";
  if (path.has_filename() && !fs::is_directory(path, ignored)) return {};
  return "This is a folder. Add the name of a file.";
}

}  // namespace

void propose_file(PanelContext& ctx, const char* title, const std::string& dialog,
                  std::string& path, const std::string& name) {
  if (!path.empty() || ImGui::IsPopupOpen(title)) return;
  const auto& names = ctx.state.saving.names;
  const auto typed = names.find(dialog);
  path = (folder_to_offer(ctx.state) / (typed == names.end() ? name : typed->second)).string();
}

std::string name_of_file(const PanelContext& ctx, const std::string& ending) {
  const std::string& file = ctx.state.file_name();
  const std::string stem = file.substr(0, std::min(file.find('.'), file.size()));
  return (stem.empty() ? "alphascope" : stem) + ending;
}

void note_file(PanelContext& ctx, const std::string& dialog, std::string& path) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(std::exchange(path, {}), ignored).lexically_normal();
  if (!whole.has_filename() || dialog.empty()) return;
  ctx.state.saving.names[dialog] = whole.filename().string();
}

bool file_row(PanelContext& ctx, const std::string& dialog, std::string& path) {
  ViewState& s = ctx.state;
  const std::string name = dialog + ".path";
  if (s.saving.found_for == name) {
    path = s.saving.found.string();
    s.saving.found_for.clear();
  }
  constexpr float kButton = 80, kGap = 6;
  row_label(ctx, "File");
  ImGui::SetNextItemWidth(ctx.px(kTextWidth - kButton - kGap));
  const bool entered = text_field(ctx, name.c_str(), path, "", KeyStop::path);
  ImGui::SameLine(0, ctx.px(kGap));
  if (button(ctx, (dialog + ".browse").c_str(), "Browse…", {ctx.px(kButton), 0})) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(path, ignored).lexically_normal();
    s.saving.browses_for = name;
    s.saving.found = whole;
    s.saving.opens_from = s.browser.folder;
    s.browser.folder = fs::is_directory(whole.parent_path(), ignored) ? whole.parent_path()
                                                                      : folder_to_offer(ctx.state);
    open_browser(ctx.state, BrowserPurpose::save);
  }
  tooltip(ctx, "Opens a dialog to find the folder, or a file to replace.");
  return entered;
}

void two_small_lines(PanelContext& ctx, const char* name, const Colour& colour,
                     const std::string& text) {
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  const float width = ctx.px(kTextWidth);
  const std::string lines = broken_lines(text, width);
  const std::size_t end = std::min(lines.find('\n'), lines.size());
  std::string rest = lines.substr(std::min(end + 1, lines.size()));
  std::replace(rest.begin(), rest.end(), '\n', ' ');
  if (rest.empty()) rest = " ";  // ImGui does not count an empty last line
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(colour));
  ImGui::TextUnformatted(
      (fitted_text(lines.substr(0, end), width) + "\n" + fitted_text(rest, width)).c_str());
  ImGui::PopStyleColor();
  if (!text.empty()) {
    if (*name != 0) record(ctx, name);
    tooltip(ctx, text.c_str());
  }
  ImGui::PopFont();
}

bool save_target(PanelContext& ctx, const std::string& dialog, const std::vector<fs::path>& files,
                 const std::string& fault) {
  std::error_code ignored;
  const fs::path& path = files.front();
  std::string why_not = why_no_name(path);
  const char* what = ".no_name";
  if (why_not.empty()) {
    why_not = as_sentence(fault);
    what = ".ending";
  }
  for (const fs::path& file : files) {
    if (!why_not.empty()) break;
    why_not = why_not_writable(file);
    what = fs::is_directory(path.parent_path(), ignored) ? ".unwritable" : ".no_folder";
  }
  const auto replaced = std::find_if(files.begin(), files.end(), [&](const fs::path& file) {
    return fs::is_regular_file(file, ignored);
  });
  if (!why_not.empty()) {
    two_small_lines(ctx, (dialog + what).c_str(), ctx.palette.error, why_not);
  } else if (replaced != files.end()) {
    two_small_lines(ctx, (dialog + ".replaces").c_str(), ctx.palette.warning,
                    replaced == files.begin()
                        ? "This file already exists and will be replaced."
                        : replaced->filename().string() + " already exists and will be replaced.");
  } else {
    two_small_lines(ctx, (dialog + ".target").c_str(), ctx.palette.text_muted, path.string());
  }
  return why_not.empty();
}

}  // namespace alphascope
