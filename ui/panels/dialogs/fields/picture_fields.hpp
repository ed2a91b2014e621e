// SPDX-License-Identifier: GPL-3.0-or-later
// Fields that several dialogs have for a picture: its size, and the marks drawn over it.
#pragma once

#include <string>

#include "core/document/picture/picture_options.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// The widgets' names begin with `dialog` and a dot.
void size_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);
// Buttons of the presets for a use of the picture. They also set light and lines of the view.
void use_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);
void background_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);
void marks_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);
// Draws the parts of the caption as check boxes, and below them the caption.
void caption_parts_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options);

}  // namespace alphascope
