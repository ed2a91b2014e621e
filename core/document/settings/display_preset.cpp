// SPDX-License-Identifier: GPL-3.0-or-later
// The titles, help and settings of each preset of the display.
#include "core/document/settings/display_preset.hpp"

#include <variant>

#include "core/document/settings/display_fields.hpp"

namespace alphascope {

const DisplayPresetInfo& preset_info(DisplayPreset preset) {
  static constexpr DisplayPresetInfo kFigure{
      "figure", "Figure",
      "The surface of the complex with shadows, outlines and fading depth, for print"};
  static constexpr DisplayPresetInfo kCavity{
      "cavity", "Cavity", "A translucent surface, through which cavities and channels are seen"};
  static constexpr DisplayPresetInfo kTeaching{
      "teaching", "Teaching",
      "Balls, edges, triangles and shrunk tetrahedra, one beside the other"};
  static constexpr DisplayPresetInfo kFast{
      "fast", "Fast",
      "Balls and tetrahedra without shadows and outlines, for large molecules on slow machines"};
  switch (preset) {
    case DisplayPreset::figure:
      return kFigure;
    case DisplayPreset::cavity:
      return kCavity;
    case DisplayPreset::teaching:
      return kTeaching;
    case DisplayPreset::fast:
      break;
  }
  return kFast;
}

std::optional<DisplayPreset> preset_named(std::string_view id) {
  for (const DisplayPreset preset : kDisplayPresets) {
    if (preset_info(preset).id == id) return preset;
  }
  return std::nullopt;
}

std::string preset_ids() {
  std::string ids;
  for (const DisplayPreset preset : kDisplayPresets) {
    ids += (ids.empty() ? "" : "|") + std::string(preset_info(preset).id);
  }
  return ids;
}

DisplaySettings with_preset(DisplaySettings display, DisplayPreset preset) {
  DisplaySettings d;
  d.beside = display.beside;
  for (const DisplayField& field : display_fields()) {
    if (!field.kept_by_presets) continue;
    std::visit([&](auto member) { d.*member = display.*member; }, field.member);
  }
  switch (preset) {
    case DisplayPreset::figure:
      d.balls = d.tetrahedra = false;
      d.boundary = true;
      break;
    case DisplayPreset::cavity:
      d.balls = d.tetrahedra = false;
      d.boundary = true;
      d.complex_opacity = 0.35f;
      d.depth_cue = 0.2f;
      break;
    case DisplayPreset::teaching:
      d.triangles = d.edges = true;
      d.singular_only = false;
      d.shrink = 0.25f;
      d.ball_scale = 0.2f;
      d.depth_cue = 0.2f;
      break;
    case DisplayPreset::fast:
      d.ambient_occlusion = false;
      d.depth_cue = 0;
      d.outlines = d.face_lines = 0;
      d.samples = 4;
      break;
  }
  return d;
}

}  // namespace alphascope
