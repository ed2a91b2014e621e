// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that dialogs share for the file that they will write: its path, and notes below it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Proposes a path in `path`, by one rule for all dialogs that write a file. The folder is that of
// the file saved last. Else it is the molecule's folder, unless that is a sample's or cannot be
// written, else the present folder. The name is the one typed last for this molecule in this
// dialog, else `name`. To be called before the dialog `title` is drawn. A path that is not empty
// stays.
void propose_file(PanelContext& ctx, const char* title, const std::string& dialog,
                  std::string& path, const std::string& name);
// Returns the stem of the open file with this ending: "4hhb.png".
std::string name_of_file(const PanelContext& ctx, const std::string& ending);
// Notes the typed file name of a dialog that closes, and clears `path`. If `dialog` is empty, no
// name is noted. The folder is noted when the file was written.
void note_file(PanelContext& ctx, const std::string& dialog, std::string& path);
// Draws the field for the path and a button that browses. Returns whether Enter was pressed.
bool file_row(PanelContext& ctx, const std::string& dialog, std::string& path);

// Draws a text of at most two lines behind an empty label. Room for both is kept even for an empty
// text, so nothing moves. A longer text is cut, and its tooltip has all of it. The widget's name
// may be empty.
void two_small_lines(PanelContext& ctx, const char* name, const Colour& colour,
                     const std::string& text);

// Shows where `files`, all in one folder, will be, and whether files there are replaced. Returns
// false if they cannot be written. `fault` names another fault of the name without a full stop, as
// fault_of_ending() does; it may be empty. Names of widgets begin with `dialog`: "save.replaces".
bool save_target(PanelContext& ctx, const std::string& dialog,
                 const std::vector<std::filesystem::path>& files, const std::string& fault = {});

}  // namespace alphascope
