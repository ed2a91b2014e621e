// See the header.
#include "ui/panels/save_parts.hpp"

#include <algorithm>
#include <utility>

#include "ui/panels/format.hpp"

namespace alphascope {

bool save_target(PanelContext& ctx, const std::filesystem::path& path) {
  std::error_code ignored;
  const bool has_folder = std::filesystem::is_directory(path.parent_path(), ignored);
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  if (std::filesystem::is_regular_file(path, ignored)) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
    ImGui::TextUnformatted("This file already exists and will be replaced.");
    ImGui::PopStyleColor();
    record(ctx, "save.replaces");
  } else if (!has_folder) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    ImGui::TextUnformatted(
        fitted_text("There is no folder " + path.parent_path().string() + ".", ctx.px(340))
            .c_str());
    ImGui::PopStyleColor();
    record(ctx, "save.no_folder");
  } else {
    muted_text(ctx, fitted_text(path.string(), ctx.px(340)));
    tooltip(ctx, path.string().c_str());
  }
  ImGui::PopFont();
  return has_folder;
}

void ask_to_save(PanelContext& ctx, TableToSave table) {
  TableMemory& memory = ctx.state.memory.save_table;
  memory.format = table.json ? memory.format : 0;
  const std::string name = table.file_name + (memory.format == 1 ? ".json" : ".csv");
  memory.path = (memory.folder / name).string();
  memory.table = std::make_shared<const TableToSave>(std::move(table));
}

RecordSource source_on_screen(const PanelContext& ctx) {
  const auto& atoms = ctx.state.references;
  return {{atoms, &atoms->molecule()},
          {atoms, &atoms->prepared()},
          ctx.state.molecule.options,
          ctx.state.program};
}

std::string file_name_for(const PanelContext& ctx, const char* what) {
  const std::string& file = ctx.state.molecule.name;
  return file.substr(0, std::min(file.find('.'), file.size())) + "-" + what;
}

}  // namespace alphascope
