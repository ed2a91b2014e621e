// Prepares tables for saving: their dialog, the origin of their numbers, and their file names.
#include "ui/panels/dialogs/save_parts.hpp"

#include <algorithm>
#include <utility>

#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {

void ask_to_save(PanelContext& ctx, TableToSave table) {
  TableMemory& memory = ctx.state.memory.save_table;
  // The last format stays if it is a table's and this table has it. Other formats serve one
  // purpose.
  memory.format = table.json && memory.format == kJsonFormat ? kJsonFormat : kCsvFormat;
  memory.path.clear();
  memory.table = std::make_shared<const TableToSave>(std::move(table));
}

FormatToSave format_to_save(const ShapeExportInfo& info, Definition<FileWriter> writer) {
  return {info.ending, info.name, info.what,
          [format = info.format](const std::filesystem::path& path) {
            return shape_export_files(format, path);
          },
          std::move(writer)};
}

RecordSource source_on_screen(const PanelContext& ctx) {
  const auto& atoms = ctx.state.references;
  return {{atoms, &atoms->molecule()},
          {atoms, &atoms->prepared()},
          ctx.state.molecule.options,
          ctx.state.program};
}

std::vector<std::string> comments_on_screen(const PanelContext& ctx) {
  std::vector<std::string> comments;
  RecordSource source = source_on_screen(ctx);
  if (ctx.inputs.balls) source = source.on(ctx.inputs.balls->lattice);
  for (const auto& [key, value] : source.provenance()) {
    if (!value.empty()) comments.push_back(key + ": " + value);
  }
  comments.push_back("program: " + ctx.state.program.text());
  return comments;
}

std::string file_name_for(const PanelContext& ctx, const char* what) {
  const std::string& file = ctx.state.molecule.name;
  return file.substr(0, std::min(file.find('.'), file.size())) + "-" + what;
}

}  // namespace alphascope
