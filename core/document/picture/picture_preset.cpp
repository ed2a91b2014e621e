// SPDX-License-Identifier: GPL-3.0-or-later
// The titles, help and values of each preset.
#include "core/document/picture/picture_preset.hpp"

#include <variant>

#include "core/document/picture/picture_options.hpp"
#include "core/document/settings/display_fields.hpp"

namespace alphascope {
namespace {

// The values of a use. Letters of a publication are 7 points high in a column of 85 mm, a usual
// width of journals.
struct UseValues {
  DisplayPreset preset;
  float outlines, face_lines, depth_cue, shadow_strength;
  int samples;
  PictureBackground background;
  int dpi, width, height;  // pixels
  double letters;
};
constexpr UseValues kUses[] = {
    {DisplayPreset::publication, 1, 0.5f, 0, 0.6f, 16, kWhiteBackground, 300, 1004, 753, 2},
    {DisplayPreset::screen, 1.5f, 1, 0.4f, 1, 16, {}, 96, 1920, 1080, 1},
    {DisplayPreset::projector, 2.5f, 1.5f, 0.2f, 0.8f, 16, kBlackBackground, 96, 1920, 1080, 2}};

const UseValues* use_values(DisplayPreset preset) {
  for (const UseValues& use : kUses) {
    if (use.preset == preset) return &use;
  }
  return nullptr;
}

}  // namespace

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
  static constexpr DisplayPresetInfo kPublication{
      "publication", "Publication",
      "White background, 300 dpi, a column of 85 mm, letters of 7 points, no fading depth"};
  static constexpr DisplayPresetInfo kScreen{
      "screen", "Screen", "The window's background, 1920 × 1080 pixels, usual lines and letters"};
  static constexpr DisplayPresetInfo kProjector{
      "projector", "Projector", "Black background, 1920 × 1080 pixels, bold lines, large letters"};
  switch (preset) {
    case DisplayPreset::figure:
      return kFigure;
    case DisplayPreset::cavity:
      return kCavity;
    case DisplayPreset::teaching:
      return kTeaching;
    case DisplayPreset::publication:
      return kPublication;
    case DisplayPreset::screen:
      return kScreen;
    case DisplayPreset::projector:
      return kProjector;
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

bool is_for_use(DisplayPreset preset) {
  return use_values(preset) != nullptr;
}

PictureOptions with_preset(PictureOptions options, DisplayPreset preset) {
  const UseValues* const use = use_values(preset);
  if (use == nullptr) return options;
  options.background = use->background;
  options.dpi = use->dpi;
  options.width = use->width;
  options.height = use->height;
  options.letters = use->letters;
  return options;
}

DisplaySettings with_preset(DisplaySettings display, DisplayPreset preset) {
  if (const UseValues* const use = use_values(preset)) {
    display.outlines = use->outlines;
    display.face_lines = use->face_lines;
    display.depth_cue = use->depth_cue;
    display.shadow_strength = use->shadow_strength;
    display.ambient_occlusion = true;
    display.samples = use->samples;
    return display;
  }
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
    case DisplayPreset::publication:
    case DisplayPreset::screen:
    case DisplayPreset::projector:
      break;  // above
  }
  return d;
}

}  // namespace alphascope
