// What dialogs that write a file have in common.
#pragma once

#include <filesystem>
#include <string>

#include "core/document/record_source.hpp"
#include "ui/panels/table_memory.hpp"
#include "ui/panels/widgets.hpp"

namespace alphascope {

// A line that says where it will be, whatever folder the program was started in, and what becomes
// of what is there. False where there is no folder for it.
bool save_target(PanelContext& ctx, const std::filesystem::path& path);

// Opens the dialog that saves a table.
void ask_to_save(PanelContext& ctx, TableToSave table);
// Where its numbers come from: what is on screen. Not without ViewState::references.
RecordSource source_on_screen(const PanelContext& ctx);
// "4hhb-cavities", of the file that is open.
std::string file_name_for(const PanelContext& ctx, const char* what);

}  // namespace alphascope
