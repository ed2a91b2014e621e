// SPDX-License-Identifier: GPL-3.0-or-later
// Presets of pictures: a whole look at once, or all values for a use of the saved picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace alphascope {

struct DisplaySettings;
struct PictureOptions;

// figure: the surface of the complex, for print.
// cavity: a translucent surface that shows cavities.
// teaching: balls, edges and tetrahedra with gaps between them.
// fast: for large molecules on slow machines.
// publication, screen, projector: for a use. They keep what is drawn and how it is coloured, and
// set light, lines, and the size, resolution, background and letters of saved pictures.
enum class DisplayPreset : std::uint8_t {
  figure,
  cavity,
  teaching,
  fast,
  publication,
  screen,
  projector
};
inline constexpr std::array kDisplayPresets = {
    DisplayPreset::figure,      DisplayPreset::cavity, DisplayPreset::teaching, DisplayPreset::fast,
    DisplayPreset::publication, DisplayPreset::screen, DisplayPreset::projector};

struct DisplayPresetInfo {
  const char* id;     // "figure"
  const char* title;  // "Figure"
  const char* help;   // a sentence without full stop
};
const DisplayPresetInfo& preset_info(DisplayPreset preset);
std::optional<DisplayPreset> preset_named(std::string_view id);
std::string preset_ids();  // "figure|cavity|..."

// Whether the preset is for a use of saved pictures.
bool is_for_use(DisplayPreset preset);

// Keeps atoms beside the body, and all settings whose row says kept_by_presets. A preset for a use
// changes light and lines only.
DisplaySettings with_preset(DisplaySettings display, DisplayPreset preset);
// The same of saved pictures. Looks change nothing; a use keeps legend, scale bar and caption.
PictureOptions with_preset(PictureOptions options, DisplayPreset preset);

}  // namespace alphascope
