// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the display: presets for the whole look, and one for each row of the table of
// settings (display_fields.hpp).
#include <utility>
#include <vector>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/document/store/answer.hpp"
#include "core/geometry/shortest_number.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

CommandSpec begun(const DisplayField& field) {
  CommandSpec spec{.id = field.command, .title = field.title, .help = field.help};
  if (field.synonyms[0] != '\0') spec.synonyms = {{field.synonyms}};
  if (field.shortcut[0] != '\0') spec.shortcuts = {{field.shortcut}};
  spec.menu = field.menu;
  spec.line_above = field.line_above;
  return spec;
}

CommandSpec switch_command(ViewState& s, const DisplayField& field) {
  CommandSpec spec = begun(field);
  if (field.needs_whole_complex) {
    spec.why_not = [&s] {
      const bool only = s.result && s.result->complex.tetrahedra_only;
      return only ? "Not computed, because “Tetrahedra only” is on." : "";
    };
  }
  return with_switch(std::move(spec),
                     s.settings.display.*std::get<bool DisplaySettings::*>(field.member));
}

CommandSpec number_command(ViewState& s, const DisplayField& field) {
  CommandSpec spec = begun(field);
  const double usual = number_of(field, DisplaySettings());
  spec.parameters = {{.name = "value",
                      .kind = Parameter::Kind::number,
                      .help = "From " + range_text(field),
                      .example = usual > 0 ? value_text(field, DisplaySettings())
                                           : shortest_number(field.rule.most / 2),
                      .rule = field.rule}};
  spec.run = [&s, &field](const Arguments& arguments) {
    set_number(field, s.settings.display, arguments.number("value"));
    return Outcome();
  };
  return spec;
}

CommandSpec paint_command(ViewState& s, const DisplayField& field) {
  CommandSpec spec = begun(field);
  spec.title += "…";
  spec.parameters = {{.name = "paint",
                      .help = scheme_ids(field.painted) +
                              ", or a colour such as #5aa9e6; a quantity also "
                              "with a colour map (" +
                              colour_map_ids() + ") and a range, with commas between",
                      .example = field.painted == PaintTarget::balls ? "b_factor,cividis,0:60"
                                                                     : "alpha,viridis,0:3"}};
  spec.run = [&s, &field](const Arguments& arguments) {
    const PaintWords words = read_paint(arguments.text("paint"), field.painted);
    if (!words.error.empty()) return Outcome::refused(words.error);
    s.settings.display.*std::get<Paint DisplaySettings::*>(field.member) = words.paint;
    if (!words.note.empty()) s.notice = words.note;
    return Outcome();
  };
  return spec;
}

CommandSpec preset_command(ViewState& s, DisplayPreset preset) {
  const DisplayPresetInfo& info = preset_info(preset);
  return {.id = std::string("view.preset_") + info.id,
          .title = std::string(is_for_use(preset) ? "Picture for: " : "Look: ") + info.id,
          .help = info.help,
          .menu = "View",
          .line_above = preset == kDisplayPresets.front(),
          .run = [&s, preset](const Arguments&) {
            s.settings.display = with_preset(s.settings.display, preset);
            s.window.picture = with_preset(s.window.picture, preset);
            return Outcome();
          }};
}

}  // namespace

CommandSpec display_command(ViewState& s, const DisplayField& field) {
  return is_switch(field)   ? switch_command(s, field)
         : is_number(field) ? number_command(s, field)
                            : paint_command(s, field);
}

void add_display_switches(Commands& commands, ViewState& s) {
  for (const DisplayField& field : display_fields()) {
    if (!is_switch(field) || field.group == DisplayGroup::projection) continue;
    commands.add(display_command(s, field));
  }
  for (const BesideKind& kind : kBesideKinds) {
    commands.add(
        with_switch({.id = command_of(kind),
                     .title = std::string(kind.title) + " beside the body",
                     .help = std::string("Draws ") + kind.id + " that are not part of the complex"},
                    s.settings.display.beside.*kind.member));
  }
}

void add_look_commands(Commands& commands, ViewState& s) {
  for (const DisplayPreset preset : kDisplayPresets) commands.add(preset_command(s, preset));
  for (const DisplayField& field : display_fields()) {
    if (is_number(field)) commands.add(display_command(s, field));
  }
  for (const DisplayField& field : display_fields()) {
    if (is_paint(field)) commands.add(display_command(s, field));
  }
}

}  // namespace alphascope
