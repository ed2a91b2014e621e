// SPDX-License-Identifier: GPL-3.0-or-later
// Sets fonts, spacing and colours. Only this file has sizes in pixels without a scale; all others
// multiply by the scale.
#include "ui/widgets/style.hpp"

#include <imgui.h>
#include <imgui_freetype.h>

#include <cmath>
#include <span>

#include "ui/inter_font.hpp"

namespace alphascope {
namespace {

ImVec4 vec4(const Colour& c, float alpha = 1.0f) {
  return {c.r, c.g, c.b, c.a * alpha};
}

// Ranges of characters: Latin-1, Greek (α), punctuation, superscripts, arrows, mathematical
// operators (≤, √).
constexpr ImWchar kGlyphRanges[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2044,
                                    0x2070, 0x209f, 0x2190, 0x21ff, 0x2200, 0x22ff,
                                    0x25a0, 0x25ff, 0x2713, 0x2717, 0};

constexpr float kBodySize = 14, kSmallSize = 12.5f, kLargeSize = 22;

ImFontConfig font_config() {
  ImFontConfig config;
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  return config;
}

ImFont* add_font(ImFontAtlas& atlas, std::span<const unsigned char> file, float pixels) {
  ImFontConfig config = font_config();
  config.FontDataOwnedByAtlas = false;  // because the atlas must not free it
  void* data = const_cast<unsigned char*>(file.data());
  return atlas.AddFontFromMemoryTTF(data, static_cast<int>(file.size()), pixels, &config,
                                    kGlyphRanges);
}

ImFont* add_mono(ImFontAtlas& atlas, const std::filesystem::path& installed, float pixels) {
  const auto file = installed / "truetype/dejavu/DejaVuSansMono.ttf";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    return add_font(atlas, inter_regular(), pixels);
  const ImFontConfig config = font_config();
  return atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, kGlyphRanges);
}

PanelFonts fill(ImFontAtlas& atlas, float scale, const std::filesystem::path& installed) {
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  PanelFonts fonts;
  fonts.regular = add_font(atlas, inter_regular(), std::round(kBodySize * scale));
  fonts.strong = add_font(atlas, inter_semibold(), std::round(kBodySize * scale));
  fonts.small = add_font(atlas, inter_regular(), std::round(kSmallSize * scale));
  fonts.large = add_font(atlas, inter_semibold(), std::round(kLargeSize * scale));
  fonts.mono = add_mono(atlas, installed, std::round(kSmallSize * scale));
  atlas.Build();
  return fonts;
}

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 3};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 12;
  style.WindowRounding = 0;
  style.ChildRounding = 4;
  style.FrameRounding = 4;
  style.PopupRounding = 6;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.DisabledAlpha = 0.5f;
}

}  // namespace

void apply_style(Theme theme, float scale) {
  const Palette& p = palette(theme);
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_sizes(style);
  style.ScaleAllSizes(scale);
  if (theme == Theme::dark) {
    ImGui::StyleColorsDark(&style);
  } else {
    ImGui::StyleColorsLight(&style);
  }
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = vec4(p.text);
  c[ImGuiCol_TextDisabled] = vec4(p.text_muted);
  c[ImGuiCol_WindowBg] = c[ImGuiCol_MenuBarBg] = vec4(p.panel);
  c[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_PopupBg] = vec4(p.panel_raised);
  c[ImGuiCol_Border] = c[ImGuiCol_Separator] = vec4(p.border);
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = vec4(p.field);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = vec4(p.field_hovered);
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = vec4(p.field_active);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = vec4(p.panel_raised);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = vec4(p.accent);
  c[ImGuiCol_SliderGrabActive] = vec4(p.accent_hovered);
  c[ImGuiCol_Header] = vec4(p.accent, 0.28f);
  c[ImGuiCol_HeaderHovered] = vec4(p.accent, 0.20f);
  c[ImGuiCol_HeaderActive] = vec4(p.accent, 0.36f);
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = vec4(p.accent);
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = vec4(p.field_active);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = vec4(p.text_disabled);
  c[ImGuiCol_TableHeaderBg] = vec4(p.field);
  c[ImGuiCol_TableBorderLight] = vec4(p.border);
  c[ImGuiCol_PlotHistogram] = vec4(p.accent);
  c[ImGuiCol_TextSelectedBg] = vec4(p.accent, 0.35f);
  c[ImGuiCol_NavHighlight] = vec4(p.accent);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, theme == Theme::dark ? 0.5f : 0.3f);
}

PanelFonts load_fonts(float scale, const std::filesystem::path& installed) {
  return fill(*ImGui::GetIO().Fonts, scale, installed);
}

void FreeAtlas::operator()(ImFontAtlas* atlas) const {
  delete atlas;
}

BuiltFonts build_fonts(float scale, const std::filesystem::path& installed) {
  BuiltFonts built;
  built.atlas.reset(new ImFontAtlas);
  built.fonts = fill(*built.atlas, scale, installed);
  unsigned char* pixels = nullptr;  // in the form that OpenGL gets; the atlas keeps them
  int width = 0, height = 0;
  built.atlas->GetTexDataAsRGBA32(&pixels, &width, &height);
  built.scale = scale;
  return built;
}

}  // namespace alphascope
