// Commands of presets for the whole look of the picture, and of its light and lines.
#include <cmath>
#include <utility>
#include <vector>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/session/settings_fields.hpp"
#include "core/document/settings/display_preset.hpp"

namespace alphascope {
namespace {

// A command with one number, which it hands to `set`.
CommandSpec number_command(const char* id, const char* title, const char* help,
                           const NumberRule& rule, std::function<void(double)> set,
                           std::vector<Synonym> synonyms = {}) {
  return {.id = id,
          .title = title,
          .help = help,
          .synonyms = std::move(synonyms),
          .parameters = {{.name = "value",
                          .kind = Parameter::Kind::number,
                          .help = "From the least to the most that the slider has",
                          .example = "1",
                          .rule = rule}},
          .run = [set = std::move(set)](const Arguments& arguments) {
            set(arguments.number("value"));
            return Outcome();
          }};
}

}  // namespace

void add_look_commands(Commands& commands, ViewState& s) {
  bool first = true;
  for (const DisplayPreset preset : kDisplayPresets) {
    const DisplayPresetInfo& info = preset_info(preset);
    commands.add({.id = std::string("view.preset_") + info.id,
                  .title = std::string("Look: ") + info.id,
                  .help = info.help,
                  .menu = "View",
                  .line_above = std::exchange(first, false),
                  .run = [&s, preset](const Arguments&) {
                    s.settings.display = with_preset(s.settings.display, preset);
                    return Outcome();
                  }});
  }
  DisplayControls& d = s.settings.display;
  commands.add(number_command("view.ball_size", "Size of balls",
                              "Draws balls of this share of their radius", kShareRule,
                              [&d](double x) { d.ball_scale = static_cast<float>(x); }));
  const std::vector<Synonym> transparency{{"transparency transparent translucent"}};
  commands.add(number_command(
      "view.ball_opacity", "Opacity of balls",
      "Draws balls as opaque as this; 1: nothing shines through", kShareRule,
      [&d](double x) { d.ball_opacity = static_cast<float>(x); }, transparency));
  commands.add(number_command(
      "view.complex_opacity", "Opacity of simplices",
      "Draws tetrahedra, triangles and boundary as opaque as this", kShareRule,
      [&d](double x) { d.complex_opacity = static_cast<float>(x); }, transparency));
  commands.add(number_command(
      "view.cavity_opacity", "Opacity of cavities",
      "Draws chosen cavities as opaque as this; below 1 what they hold "
      "shines through",
      kShareRule, [&d](double x) { d.cavity_opacity = static_cast<float>(x); }, transparency));
  commands.add(number_command("view.shrink", "Shrink tetrahedra",
                              "Draws tetrahedra smaller by this share, apart from each other",
                              kShrinkRule, [&d](double x) { d.shrink = static_cast<float>(x); }));
  commands.add(number_command(
      "view.depth_cue", "Depth cue", "Lets what is far away fade into the background by this share",
      kDepthCueRule, [&d](double x) { d.depth_cue = static_cast<float>(x); }));
  commands.add(number_command("view.outlines", "Outlines",
                              "Draws outlines of this width in pixels; 0: none", kSilhouettesRule,
                              [&d](double x) { d.silhouettes = static_cast<float>(x); }));
  commands.add(number_command("view.face_lines", "Lines around faces",
                              "Draws darker lines of this width in pixels around faces; 0: none",
                              kFaceEdgesRule,
                              [&d](double x) { d.face_edges = static_cast<float>(x); }));
  commands.add(number_command("view.edge_thickness", "Thickness of edges",
                              "Draws edges as rods of this thickness in Å", kEdgeThicknessRule,
                              [&d](double x) { d.edge_thickness = static_cast<float>(x); }));
  commands.add(number_command(
      "view.samples", "Samples a pixel", "Averages so many pictures at rest and in saved pictures",
      kSamplesRule, [&d](double x) { d.samples = static_cast<int>(std::lround(x)); }));
}

}  // namespace alphascope
