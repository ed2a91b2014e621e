// SPDX-License-Identifier: GPL-3.0-or-later
// Presets of the display: settings of a whole look at once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace alphascope {

struct DisplaySettings;

// figure: the surface of the complex, for print.
// cavity: a translucent surface that shows cavities.
// teaching: balls, edges and tetrahedra with gaps between them.
// fast: for large molecules on slow machines.
enum class DisplayPreset : std::uint8_t { figure, cavity, teaching, fast };
inline constexpr std::array kDisplayPresets = {DisplayPreset::figure, DisplayPreset::cavity,
                                               DisplayPreset::teaching, DisplayPreset::fast};

struct DisplayPresetInfo {
  const char* id;     // "figure"
  const char* title;  // "Figure"
  const char* help;   // a sentence without full stop
};
const DisplayPresetInfo& preset_info(DisplayPreset preset);
std::optional<DisplayPreset> preset_named(std::string_view id);
std::string preset_ids();  // "figure|cavity|..."

// Keeps atoms beside the body, and all settings whose row says kept_by_presets.
DisplaySettings with_preset(DisplaySettings display, DisplayPreset preset);

}  // namespace alphascope
