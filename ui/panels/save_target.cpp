// See the header.
#include "ui/panels/save_target.hpp"

#include <algorithm>

#include "core/io/atomic_file.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr float kTextWidth = 340;  // pixels at scale 1

void coloured_text(const Colour& colour, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(colour));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

bool save_target(PanelContext& ctx, const std::string& dialog, const std::vector<fs::path>& files) {
  std::error_code ignored;
  const fs::path& path = files.front();
  const bool has_folder = fs::is_directory(path.parent_path(), ignored);
  std::string why_not;
  for (const fs::path& file : files) {
    if (why_not.empty()) why_not = why_not_writable(file);
  }
  const auto replaced = std::find_if(files.begin(), files.end(), [&](const fs::path& file) {
    return fs::is_regular_file(file, ignored);
  });
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  if (!why_not.empty()) {
    coloured_text(ctx.palette.error, fitted_text(why_not, ctx.px(kTextWidth)));
    record(ctx, (dialog + (has_folder ? ".unwritable" : ".no_folder")).c_str());
    tooltip(ctx, why_not.c_str());
  } else if (replaced != files.end()) {
    coloured_text(
        ctx.palette.warning,
        replaced == files.begin()
            ? "This file already exists and will be replaced."
            : fitted_text(replaced->filename().string() + " already exists and will be replaced.",
                          ctx.px(kTextWidth)));
    record(ctx, (dialog + ".replaces").c_str());
  } else {
    muted_text(ctx, fitted_text(path.string(), ctx.px(kTextWidth)));
    tooltip(ctx, path.string().c_str());
  }
  ImGui::PopFont();
  return why_not.empty();
}

}  // namespace alphascope
