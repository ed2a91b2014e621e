// See the header.
#include "ui/panels/save_target.hpp"

#include <algorithm>

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
  const auto replaced = std::find_if(files.begin(), files.end(), [&](const fs::path& file) {
    return fs::is_regular_file(file, ignored);
  });
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  if (replaced != files.end()) {
    coloured_text(
        ctx.palette.warning,
        replaced == files.begin()
            ? "This file already exists and will be replaced."
            : fitted_text(replaced->filename().string() + " already exists and will be replaced.",
                          ctx.px(kTextWidth)));
    record(ctx, (dialog + ".replaces").c_str());
  } else if (!has_folder) {
    coloured_text(
        ctx.palette.error,
        fitted_text("There is no folder " + path.parent_path().string() + ".", ctx.px(kTextWidth)));
    record(ctx, (dialog + ".no_folder").c_str());
  } else {
    muted_text(ctx, fitted_text(path.string(), ctx.px(kTextWidth)));
    tooltip(ctx, path.string().c_str());
  }
  ImGui::PopFont();
  return has_folder;
}

}  // namespace alphascope
