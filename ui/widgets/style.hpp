// Fonts, spacing and colours of the window in ImGui's terms.
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

// Fills the font atlas of the current context with Inter, which the program brings along, and for
// hashes with DejaVu's monospaced font where it is installed; the atlas is built. Call between
// frames only.
PanelFonts load_fonts(float scale, const std::filesystem::path& installed = "/usr/share/fonts");

}  // namespace alphascope
