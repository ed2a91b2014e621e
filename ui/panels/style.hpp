// Fonts, spacing and colours of the window in ImGui's terms.
#pragma once

#include <filesystem>
#include <optional>

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

// Fills the font atlas of the current context with Inter or, where it is not installed, DejaVu, or
// ImGui's built-in font; the atlas is built. Call between frames only.
PanelFonts load_fonts(float scale);

// The folder of installed fonts can be replaced, to test machines without any.
std::optional<std::filesystem::path> find_font(
    const char* relative_path, const std::filesystem::path& root = "/usr/share/fonts");

}  // namespace alphascope
