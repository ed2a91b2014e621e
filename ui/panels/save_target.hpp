// What a dialog says below the name of a file that it will write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/panels/widgets.hpp"

namespace alphascope {

// Where `files`, in one folder, will be, whatever folder the program was started in, and what
// becomes of what is there. False where they cannot be written. Widgets are named by
// `dialog`: "save.replaces".
bool save_target(PanelContext& ctx, const std::string& dialog,
                 const std::vector<std::filesystem::path>& files);

}  // namespace alphascope
