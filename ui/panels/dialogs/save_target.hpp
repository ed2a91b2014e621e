// What a dialog says below the name of a file that it will write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// One rule for all dialogs that write a file. The folder that is offered is that of the file that
// was saved last, else that of the molecule where one may write there, else the present one. The
// name is what was typed last for this molecule in this dialog, else `name`. To be called before
// the dialog `title` is drawn; a path that is there already stays.
void propose_file(PanelContext& ctx, const char* title, const std::string& dialog,
                  std::string& path, const std::string& name);
// "4hhb" and this ending.
std::string name_of_file(const PanelContext& ctx, const std::string& ending);
// The dialog is closed: what it remembers. Without a name of the dialog, the folder only.
void note_file(PanelContext& ctx, const std::string& dialog, std::string& path, bool saved);
// The path, and a button that looks for it. True: Enter was pressed in it.
bool file_row(PanelContext& ctx, const std::string& dialog, std::string& path);

// Behind an empty label: room for two lines, whether or not it says anything, so that nothing
// moves. What does not fit is cut; its tooltip has all. The widget's name may be empty.
void two_small_lines(PanelContext& ctx, const char* name, const Colour& colour,
                     const std::string& text);

// Where `files`, in one folder, will be, whatever folder the program was started in, and what
// becomes of what is there. False where they cannot be written. `fault`: what else is wrong with
// the name, without full stop, as of fault_of_ending(); or empty. Widgets are named by `dialog`:
// "save.replaces".
bool save_target(PanelContext& ctx, const std::string& dialog,
                 const std::vector<std::filesystem::path>& files, const std::string& fault = {});

}  // namespace alphascope
