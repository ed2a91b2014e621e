// SPDX-License-Identifier: GPL-3.0-or-later
// Fonts, spacing and colours of the window for ImGui.
#pragma once

#include <filesystem>

#include "ui/theme.hpp"

struct ImFont;

namespace alphascope {

struct PanelFonts {
  ImFont* regular = nullptr;
  ImFont* strong = nullptr;
  ImFont* small = nullptr;
  ImFont* large = nullptr;
  ImFont* mono = nullptr;
};

// Sets colours and, for a display of `scale` (1 = 96 dpi), spacing of the current ImGui context.
void apply_style(Theme theme, float scale);

// Fills the font atlas of the current context with Inter, which is part of the program. Hashes get
// DejaVu's monospaced font if it is installed. Builds the atlas. Call it between frames only.
PanelFonts load_fonts(float scale, const std::filesystem::path& installed = "/usr/share/fonts");

}  // namespace alphascope
