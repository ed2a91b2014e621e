// SPDX-License-Identifier: GPL-3.0-or-later
// Fonts, spacing and colours of the window for ImGui.
#pragma once

#include <filesystem>
#include <memory>

#include "ui/theme.hpp"

struct ImFont;
struct ImFontAtlas;

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

struct FreeAtlas {
  void operator()(ImFontAtlas* atlas) const;
};

// Fonts that were made before there is a context of ImGui.
struct BuiltFonts {
  std::unique_ptr<ImFontAtlas, FreeAtlas> atlas;  // outlives the context
  PanelFonts fonts;
  float scale = 0;
};

// The same fonts in an atlas of their own. Any thread may build it while there is no context.
BuiltFonts build_fonts(float scale, const std::filesystem::path& installed = "/usr/share/fonts");

}  // namespace alphascope
