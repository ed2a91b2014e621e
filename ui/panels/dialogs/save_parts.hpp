// What pages ask for to have a table saved.
#pragma once

#include <string>
#include <vector>

#include "core/document/export/record_source.hpp"
#include "core/document/export/shape_export.hpp"
#include "ui/panels/dialogs/table_memory.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// A format for other programs.
FormatToSave format_to_save(const ShapeExportInfo& info, Definition<FileWriter> writer);
// Opens the dialog that saves a table.
void ask_to_save(PanelContext& ctx, TableToSave table);
// Where its numbers come from: what is on screen. Not without ViewState::references.
RecordSource source_on_screen(const PanelContext& ctx);
// The same and the program's version, as lines above a table: "radii: CASTp".
std::vector<std::string> comments_on_screen(const PanelContext& ctx);
// "4hhb-cavities", of the file that is open.
std::string file_name_for(const PanelContext& ctx, const char* what);

}  // namespace alphascope
