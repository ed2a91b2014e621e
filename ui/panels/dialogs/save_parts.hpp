// SPDX-License-Identifier: GPL-3.0-or-later
// Functions with which pages ask for a table to be saved.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

template <class T>
struct Definition;
struct FileWriter;
struct FormatToSave;
struct PanelContext;
struct RecordSource;
struct ShapeExportInfo;
struct TableToSave;

// Makes an entry for a format that is not a table's.
FormatToSave format_to_save(const ShapeExportInfo& info, Definition<FileWriter> writer);
// Makes an entry for the figure of a page, which is this SVG document.
FormatToSave figure_to_save(std::string svg);
// Opens the dialog that saves a table.
void open_save_dialog(PanelContext& ctx, TableToSave table);
// Returns the source of the numbers on screen. ViewState::references must not be null.
RecordSource source_on_screen(const PanelContext& ctx);
// Returns the same source and the program's version as lines above a table: "radii: CASTp".
std::vector<std::string> comments_on_screen(const PanelContext& ctx);
// Returns a file name for the open file: "4hhb-cavities".
std::string file_name_for(const PanelContext& ctx, const char* what);

}  // namespace alphascope
