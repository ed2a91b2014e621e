// What dialogs ask of a picture: its size and what is drawn over it.
#pragma once

#include <string>

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Names of the fields begin with `dialog` and a dot.
void size_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);
void marks_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);

}  // namespace alphascope
