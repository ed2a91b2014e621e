// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares tables for saving: their dialog, the origin of their numbers, and their file names.
#include "ui/panels/dialogs/save_parts.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "core/document/export/file_writer.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/export/shape_export.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/files/atomic_file.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/triangulation/memory_need.hpp"
#include "ui/panels/dialogs/table_state.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void open_save_dialog(PanelContext& ctx, TableToSave table) {
  TableState& memory = ctx.state.save_table;
  // JSON stays chosen if it was and this table has it. Formats for other programs serve one table
  // only, so none of them stays.
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

FormatToSave figure_to_save(std::string svg) {
  const auto text = std::make_shared<const std::string>(std::move(svg));
  const auto key = [number = std::hash<std::string>()(*text)](const Inputs&) {
    return Key{1, 0, number | 1};
  };
  const auto write = [text](const std::filesystem::path&, const std::vector<AtomicFile*>& files,
                            const RunContext&) { files.front()->write(*text); };
  return {".svg",
          "SVG: figure",
          "the plot, for word processors and browsers",
          [](const std::filesystem::path& path) { return std::vector{path}; },
          {{.id = "figure",
            .title = "A figure",
            .key = key,
            .memory =
                [](const Inputs&) {
                  return MemoryNeed{0, 0};
                },
            .keep_stale = false},
           [write](const Inputs&, const RunContext&) {
             return std::make_shared<const FileWriter>(FileWriter{write});
           }}};
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
  const std::string& file = ctx.state.file_name();
  return file.substr(0, std::min(file.find('.'), file.size())) + "-" + what;
}

}  // namespace alphascope
