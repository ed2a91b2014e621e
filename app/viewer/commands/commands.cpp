// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the menus File, Edit, View and Help. A new command is one more add() here or in a
// source beside this one.
#include "app/viewer/commands/commands.hpp"

#include <stdexcept>

#include <filesystem>
#include <utility>

#include "app/viewer/commands/command_parts.hpp"
#include "core/chart/colour_scale.hpp"
#include "core/document/export/complex_export.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/picture_options.hpp"
#include "core/files/output_ending.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/read/file_format.hpp"
#include "core/text/as_sentence.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

std::function<std::string()> without_molecule(const ViewState& s) {
  return [&s] { return s.molecule.loaded ? "" : "No molecule is open."; };
}

std::function<std::string()> without_result(const ViewState& s) {
  return [&s] { return s.result ? "" : "There is no complex yet."; };
}

Outcome set_switch(const Arguments& arguments, bool& value) {
  const std::string wanted = arguments.text("state");
  value = wanted.empty() ? !value : wanted == "on";
  return {};
}

Parameter on_or_off() {
  Parameter p{
      .name = "state", .kind = Parameter::Kind::choice, .help = "On or off", .optional = true};
  p.choices = [] { return std::vector<Choice>{{"on", "On"}, {"off", "Off"}}; };
  return p;
}

CommandSpec with_switch(CommandSpec spec, bool& value) {
  spec.parameters = {on_or_off()};
  spec.checked = [&value] { return value; };
  spec.run = [&value](const Arguments& arguments) { return set_switch(arguments, value); };
  return spec;
}

namespace {

using Kind = Parameter::Kind;

// --- File

Outcome open_file(const Arguments& arguments, ViewState& s, const Calls& ask) {
  if (!arguments.has("path")) {
    open_browser(s);
    return {};
  }
  const std::filesystem::path path = arguments.text("path");
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return Outcome::refused("There is no file " + printable(path.string()) + ".");
  }
  ask.files.open(path);
  return {};
}

std::vector<Choice> samples(const ViewState& s) {
  std::vector<Choice> choices;
  for (const SampleMolecule& sample : s.samples) {
    choices.push_back({sample.name, sample.name, sample.detail});
  }
  return choices;
}

Outcome open_sample(const Arguments& arguments, ViewState& s, const Calls& ask) {
  for (const SampleMolecule& sample : s.samples) {
    if (sample.name == arguments.text("sample")) ask.files.open(sample.path);
  }
  return {};
}

// Without a path the dialog asks for all parameters.
Outcome save_picture(const Arguments& arguments, ViewState& s, const Calls& ask) {
  DialogState& m = s.dialogs;
  if (!arguments.has("path")) {
    m.show_save = true;
    return {};
  }
  PictureOptions options = s.window.picture;
  options.width = static_cast<int>(arguments.number("width", options.width));
  options.height = static_cast<int>(arguments.number("height", options.height));
  options.dpi = static_cast<int>(arguments.number("dpi", options.dpi));
  if (arguments.has("background")) {
    const auto background = read_background(arguments.text("background"));
    if (!background) {
      return Outcome::refused(std::string("The background is one of: ") + kBackgroundWords + ".");
    }
    options.background = *background;
  }
  if (arguments.has("transparent")) options.background = kNoBackground;
  options.scale_bar |= arguments.has("scale-bar");
  try {
    if (arguments.has("caption")) options.caption = read_caption_parts(arguments.text("caption"));
  } catch (const std::invalid_argument& error) {
    return Outcome::refused("Caption: " + std::string(error.what()) + ".");
  }
  const std::filesystem::path path = path_to_save(arguments.text("path"), kPictureEnding);
  const std::string fault = fault_of_ending(path, {kPictureEnding});
  if (!fault.empty()) return Outcome::refused(as_sentence(fault));
  ask.jobs.save_picture({path, options});
  return {};
}

// Without a path the dialog asks for it.
Outcome export_complex(const Arguments& arguments, ViewState& s, const Calls& ask) {
  DialogState& m = s.dialogs;
  if (!arguments.has("path")) {
    m.show_export = true;
    return {};
  }
  std::error_code ignored;
  const std::filesystem::path path =
      std::filesystem::absolute(arguments.text("path"), ignored).lexically_normal();
  if (export_format_of(path) == nullptr) {
    return Outcome::refused("No format has the ending of " + printable(path.filename().string()) +
                            ". The endings are " + export_endings() + ".");
  }
  const std::string colours = arguments.text("colours");
  ask.jobs.export_complex(ExportRequest{path, colours == "chain"     ? ExportColours::chain
                                              : colours == "solid"   ? ExportColours::solid
                                              : colours == "element" ? ExportColours::element
                                                                     : m.export_colours});
  return {};
}

Parameter pixels(const char* name, const char* help) {
  return {
      .name = name, .kind = Kind::number, .help = help, .optional = true, .rule = kPictureSizeRule};
}

void add_file_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(
      {.id = "file.open",
       .title = "Open molecule…",
       .help = "Reads a file: " + format_names() + "; also as .gz",
       .synonyms = {{"load read import"}},
       .shortcuts = {{"Ctrl+O"}},
       .menu = "File",
       .parameters = {{.name = "path",
                       .kind = Kind::path,
                       .help = "The file; if left out, a dialog opens",
                       .optional = true}},
       .run = [&s, ask](const Arguments& arguments) { return open_file(arguments, s, ask); }});
  commands.add(fetch_command(s, ask));
  commands.add(open_session_command(s, ask));
  commands.add(recent_files_command(s, ask));
  commands.add({.id = "file.close",
                .title = "Close the molecule",
                .help = "Closes the molecule without saving a session, and shows the start page",
                .synonyms = {{"start page new empty"}},
                .shortcuts = {{"Ctrl+W"}},
                .menu = "File",
                .why_not = [&s]() -> std::string {
                  if (!s.molecule.loaded) return "No molecule is open.";
                  if (s.lessons.open) return "A lesson is open. Close the lesson first.";
                  return s.benchmark.running ? "A benchmark is running. Cancel it first." : "";
                },
                .run =
                    [ask](const Arguments&) {
                      ask.files.close_file();
                      return Outcome();
                    }});
  commands.add(
      {.id = "file.sample",
       .title = "Sample molecule",
       .help = "Opens a molecule that comes with the program",
       .menu = "File",
       .parameters = {{.name = "sample",
                       .kind = Kind::choice,
                       .help = "Which molecule",
                       .choices = [&s] { return samples(s); }}},
       .run = [&s, ask](const Arguments& arguments) { return open_sample(arguments, s, ask); }});
  commands.add(
      {.id = "file.save_picture",
       .title = "Save picture…",
       .help = "Writes the view as a PNG file",
       .synonyms = {{"image screenshot figure PNG"}},
       .shortcuts = {{"Ctrl+S"}},
       .menu = "File",
       .line_above = true,
       .parameters = {{.name = "path",
                       .kind = Kind::path,
                       .help = "The PNG file; if left out, a dialog opens",
                       .optional = true},
                      pixels("width", "Width in pixels; if left out, as in the dialog"),
                      pixels("height", "Height in pixels; if left out, as in the dialog"),
                      {.name = "caption",
                       .kind = Kind::text,
                       .help = "Parts of the caption: usual, all, none, or some of " +
                               caption_part_ids() +
                               " with commas between; if left out, as in the dialog",
                       .example = "alpha,counts",
                       .optional = true},
                      {.name = "background",
                       .kind = Kind::text,
                       .help = std::string(kBackgroundWords) + "; if left out, as in the dialog",
                       .example = "white",
                       .optional = true},
                      {.name = "dpi",
                       .kind = Kind::number,
                       .help = "Resolution that the file states; if left out, as in the dialog",
                       .optional = true,
                       .rule = kDpiRule},
                      {.name = "transparent", .kind = Kind::flag, .help = "Without background"},
                      {.name = "scale-bar", .kind = Kind::flag, .help = "With a scale bar"}},
       .why_not = without_molecule(s),
       .run = [&s, ask](const Arguments& arguments) { return save_picture(arguments, s, ask); }});
  commands.add({.id = "file.copy_picture",
                .title = "Copy picture",
                .help = "Puts the view on the clipboard, as it would be saved",
                .synonyms = {{"clipboard image"}},
                .shortcuts = {{"Ctrl+Shift+C"}},
                .menu = "File",
                .why_not = without_molecule(s),
                .run = [&s, ask](const Arguments&) {
                  ask.jobs.save_picture({{}, s.window.picture});
                  return Outcome();
                }});
  commands.add(record_command(s, ask));
  commands.add(
      {.id = "file.export",
       .title = "Export…",
       .help = "Writes boundary, simplices or balls for another program",
       .synonyms = {{"mesh STL OBJ PLY surface print"}},
       .shortcuts = {{"Ctrl+E"}},
       .menu = "File",
       .parameters = {{.name = "path",
                       .kind = Kind::path,
                       .help = "The file; its ending chooses the format; if left out, a dialog "
                               "opens",
                       .optional = true},
                      {.name = "colours",
                       .kind = Kind::choice,
                       .help = "Colours of the boundary",
                       .optional = true,
                       .choices =
                           [] {
                             return std::vector<Choice>{{"element", "By element"},
                                                        {"chain", "By chain"},
                                                        {"solid", "By solid"}};
                           }}},
       .why_not = without_result(s),
       .run = [&s, ask](const Arguments& arguments) { return export_complex(arguments, s, ask); }});
  commands.add(save_session_command(s, ask));
  commands.add({.id = "file.quit",
                .title = "Quit",
                .help = "Ends the program",
                .shortcuts = {{"Ctrl+Q"}},
                .menu = "File",
                .line_above = true,
                .run = [ask](const Arguments&) {
                  ask.files.quit();
                  return Outcome();
                }});
}

// --- Edit

void add_edit_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(
      {.id = "edit.undo",
       .title = "Undo",
       .help = "Undoes the last change of atoms, radii, alpha, engine, display or selection",
       .shortcuts = {{"Ctrl+Z"}},
       .menu = "Edit",
       .why_not = [&s] { return s.undo_text.empty() ? "There is nothing to undo." : ""; },
       .run =
           [ask](const Arguments&) {
             ask.files.undo();
             return Outcome();
           }});
  commands.add({.id = "edit.redo",
                .title = "Redo",
                .help = "Makes the last undone change again",
                .shortcuts = {{"Ctrl+Shift+Z"}, {"Ctrl+Y"}},
                .menu = "Edit",
                .why_not = [&s] { return s.redo_text.empty() ? "There is nothing to redo." : ""; },
                .run =
                    [ask](const Arguments&) {
                      ask.files.redo();
                      return Outcome();
                    }});
}

// --- View

void add_view_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add({.id = "view.reset",
                .title = "Reset view",
                .help = "Shows the whole molecule",
                .synonyms = {{"fit all home"}},
                .shortcuts = {{"R"}},
                .menu = "View",
                .why_not = without_molecule(s),
                .run = [ask](const Arguments&) {
                  ask.view.reset();
                  return Outcome();
                }});
  add_display_switches(commands, s);
  CommandSpec theme{.id = "view.light_theme",
                    .title = "Light theme",
                    .help = "Switches between a light and a dark window",
                    .synonyms = {{"white background"}},
                    .shortcuts = {{"Ctrl+L"}},
                    .menu = "View",
                    .line_above = true,
                    .parameters = {on_or_off()}};
  theme.checked = [&s] { return s.window.theme == Theme::light; };
  theme.run = [&s](const Arguments& arguments) {
    bool light = s.window.theme == Theme::light;
    Outcome outcome = set_switch(arguments, light);
    s.window.theme = light ? Theme::light : Theme::dark;
    return outcome;
  };
  commands.add(std::move(theme));
  commands.add(scale_command(s));
  commands.add(with_switch({.id = "view.presenter_size",
                            .title = "Presenter size",
                            .help = "Makes text, controls and lines larger, for a projector",
                            .menu = "View"},
                           s.window.presenter_size));
  commands.add(page_command(s));
  commands.add(section_command(s));
}

// --- Help

void add_help_commands(Commands& commands, ViewState& s) {
  commands.add({.id = "help.commands",
                .title = "Find a command…",
                .help = "Lists all commands",
                .shortcuts = {{"Ctrl+P"}},
                .menu = "Help",
                .run = [&s](const Arguments&) {
                  s.palette = {.show = true};
                  return Outcome();
                }});
  commands.add({.id = "help.keys",
                .title = "Mouse and keyboard",
                .help = "Shows or hides the list of mouse actions and keys",
                .shortcuts = {{"F1"}},
                .works_everywhere = true,
                .menu = "Help",
                .run = [&s](const Arguments&) {
                  s.dialogs.show_cheat_sheet = !s.dialogs.show_cheat_sheet;
                  return Outcome();
                }});
  commands.add({.id = "help.about",
                .title = "About Alphascope",
                .help = "Version, licence and the libraries used",
                .menu = "Help",
                .line_above = true,
                .run = [&s](const Arguments&) {
                  s.dialogs.show_about = true;
                  return Outcome();
                }});
}

}  // namespace

void add_program_commands(Commands& commands, ViewState& state, const Calls& ask,
                          PanelSet& panels) {
  add_file_commands(commands, state, ask);
  add_edit_commands(commands, state, ask);
  add_selection_commands(commands, state, ask);
  add_appearance_commands(commands, state);
  add_annotation_commands(commands, state, ask);
  add_pointed_commands(commands, state, ask);
  add_view_commands(commands, state, ask);
  add_look_commands(commands, state);
  add_camera_commands(commands, state, ask);
  add_object_commands(commands, state);
  add_clip_commands(commands, state, ask);
  add_compute_commands(commands, state, ask);
  add_why_commands(commands, state);
  add_steps_commands(commands, state);
  add_sandbox_commands(commands, state, ask);
  add_lesson_commands(commands, state, ask);
  panels.add_commands(commands, state);
  add_help_commands(commands, state);
}

}  // namespace alphascope
