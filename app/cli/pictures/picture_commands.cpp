// SPDX-License-Identifier: GPL-3.0-or-later
// The options of alphascope-cli screenshot and frames.
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "app/cli/command.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "app/options/did_you_mean.hpp"
#include "app/options/option_values.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/picture/frame_names.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/document/settings/paint.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope::cli {
namespace {

Option drawing_memory(std::optional<std::uint64_t>& megabytes) {
  Option option{.names = "--drawing-memory",
                .value = "MB",
                .text = "Assume this amount of free memory for drawing, in MB",
                .fallback = "measured"};
  option.set = [&megabytes](const std::string& value) {
    megabytes = static_cast<std::uint64_t>(whole_number_in(value, {0, 2'000'000'000, "MB"}));
  };
  return option;
}

Option caption(CaptionParts& parts) {
  Option option{.names = "--caption",
                .value = "PARTS",
                .text = "Parts of the caption at the top: usual, all, none, or some of " +
                        caption_part_ids() + " with commas between",
                .fallback = caption_parts_text(parts)};
  option.set = [&parts](const std::string& value) { parts = read_caption_parts(value); };
  return option;
}

Option dpi(std::optional<int>& dots) {
  Option option{.names = "--dpi",
                .value = "N",
                .text = "Dots per inch that the file states, and for a --size in mm",
                .fallback = std::to_string(PictureOptions().dpi) + ", or the preset's"};
  option.set = [&dots](const std::string& value) {
    dots = static_cast<int>(whole_number_in(value, {kDpiRule.least, kDpiRule.most, "dpi"}));
  };
  return option;
}

Option background(std::optional<PictureBackground>& chosen) {
  Option option{.names = "--background",
                .value = "COLOUR",
                .text = std::string("Background: ") + kBackgroundWords,
                .fallback = "theme, or the preset's"};
  option.set = [&chosen](const std::string& value) {
    chosen = read_background(value);
    if (!chosen) {
      throw std::invalid_argument(std::string("the background is one of: ") + kBackgroundWords);
    }
  };
  return option;
}

Option letters(std::optional<double>& size) {
  Option option{.names = "--letters",
                .value = "X",
                .text = "Factor on the size of letters: legend, scale bar, caption, labels",
                .fallback = "1, or the preset's"};
  option.set = [&size](const std::string& value) {
    size = number_in(value, {kLettersRule.least, kLettersRule.most});
  };
  return option;
}

Option not_required(Option option) {
  option.required = false;
  return option;
}

// An option that changes one setting of the display.
Option display_option(const DisplayField& field, DisplayChanges& changes) {
  const DisplayOption& named = field.option;
  Option option{.names = named.name, .text = named.text[0] == '\0' ? field.help : named.text};
  if (is_switch(field)) {
    option.set = [&field, &changes](const std::string&) {
      changes.emplace_back(&field, field.option.sets ? 1 : 0);
    };
    return option;
  }
  option.value = field.rule.whole ? "N" : "X";
  option.text += "; from " + range_text(field);
  option.fallback = value_text(field, DisplaySettings()) + ", or the preset's";
  option.set = [&field, &changes](const std::string& value) {
    const NumberRange range{field.rule.least, field.rule.most};
    changes.emplace_back(
        &field, field.rule.whole ? whole_number_in(value, range) : number_in(value, range));
  };
  return option;
}

// Options of the display that are switches or numbers. paint_option() makes options of colours.
Options display_options(DisplayChanges& changes) {
  Options options;
  for (const DisplayField& field : display_fields()) {
    if (field.option.name[0] == '\0' || is_paint(field)) continue;
    options.push_back(display_option(field, changes));
  }
  return options;
}

std::string kinds_beside_body() {
  std::string ids;
  for (const BesideKind& kind : kBesideKinds)
    ids += (ids.empty() ? "" : ", ") + std::string(kind.id);
  return ids;
}

Paint paint_from(const std::string& text, PaintTarget what, std::vector<std::string>& notes) {
  const PaintWords words = read_paint(text, what);
  if (!words.note.empty()) notes.push_back(words.note);
  if (words.error.empty()) return words.paint;
  std::vector<std::string> schemes;
  for (const SchemeInfo& scheme : all_schemes()) schemes.push_back(scheme.id);
  throw std::invalid_argument(words.error + did_you_mean(text, schemes));
}

Option paint_option(OptionText text, const char* fallback,
                    std::function<void(const std::string&)> set) {
  return {.names = std::move(text.names),
          .value = std::move(text.value),
          .text = std::move(text.text),
          .fallback = fallback,
          .set = std::move(set)};
}

// Makes an option note that it was given, if a session would set the same. These are all options
// but those of the picture's file.
void note_what_sessions_say(Option& option, ScreenshotCommandOptions& options) {
  constexpr std::string_view kOfThePicture[] = {
      "FILE",        "--session",        "--output",  "--size", "--transparent", "--no-legend",
      "--scale-bar", "--drawing-memory", "--caption", "--dpi",  "--background",  "--letters"};
  const std::string name = option.shown_name();
  if (std::find(std::begin(kOfThePicture), std::end(kOfThePicture), name) !=
      std::end(kOfThePicture)) {
    return;
  }
  option.set = [&options, name, set = option.set](const std::string& value) {
    options.beside_session.push_back(name);
    set(value);
  };
}

void require_one_source(const ScreenshotCommandOptions& options, bool needs_alpha) {
  const auto& given = options.beside_session;
  if (options.session.empty()) {
    const bool alpha = std::find(given.begin(), given.end(), "--alpha") != given.end();
    if (options.input.file.empty()) throw std::invalid_argument("FILE is required, or --session");
    if (!alpha && needs_alpha) throw std::invalid_argument("--alpha is required, or --session");
  } else if (!options.beside_session.empty()) {
    throw std::invalid_argument("the session already has the setting of " +
                                options.beside_session.front() +
                                "; leave the option out, or change it in the window and save "
                                "the session again");
  }
}

Option objects(DrawnObjects& objects) {
  return {.names = "--objects",
          .value = "LIST",
          .text = "Drawings of atoms beside the complex: " + object_kind_ids() +
                  ", each with a colour (" + object_colour_ids() +
                  ", or #rrggbb), an opacity and a selection, or without: "
                  "\"cartoon,secondary,40%:chain A; sticks:ligand\"",
          .fallback = "none",
          .set = [&objects](const std::string& text) {
            ObjectListWords words = read_objects(text);
            if (!words.error.empty()) throw std::invalid_argument(words.error);
            objects = std::move(words.objects);
          }};
}

// Options of each picture, single or as a frame.
Options picture_options(ScreenshotCommandOptions& options) {
  Options all{
      with_default(
          text_option({"--size", "WxH", "Width and height in pixels, or in print such as 85x64mm"},
                      options.size),
          std::string(kUsualSize) + ", or the preset's"),
      dpi(options.dpi),
      background(options.background),
      flag_option("--transparent", "No background, as --background transparent",
                  options.transparent),
      flag_option("--light", "Light background", options.light),
      text_option({"--clip", "CLIP",
                   "Cut the picture open at a plane, or by a slab: x, y=12.5 (Å), -z=3, view, "
                   "1,1,0=5; with a thickness x=12.5:8"},
                  options.clip),
      with_default(choice_option({"--preset", preset_ids(),
                                  "Preset of the look; other options change parts of it"},
                                 options.preset),
                   "none"),
      text_option({"--hide", "ATOMS",
                   "Hide these atoms, and simplices with a corner among them; an expression as "
                   "for --select"},
                  options.appearance.hide),
      text_option({"--only", "ATOMS", "Hide all other atoms"}, options.appearance.only),
      text_option(
          {"--atom-colours", "LIST", "Colours of single atoms: \"resn HEM=#ff8800; chain A=#888\""},
          options.appearance.colours),
      text_option({"--labels", "LIST",
                   "Labels of atoms: name, residue, address, element, radius or b_factor: \"resn "
                   "HEM=residue; name FE=name\""},
                  options.annotations.labels),
      texts_option(
          {"--measure", "ATOMS",
           "Draw the distance of two atoms, the angle of three or the dihedral angle of four: "
           "\"A:HIS 87:NE2; A:HEM 142:FE\"; commas between several"},
          options.annotations.measurements),
      paint_option({display_field(&DisplaySettings::ball_paint).option.name, "PAINT",
                    "Colours of balls: " + scheme_ids(PaintTarget::balls) +
                        ", or a colour such as #5aa9e6; a quantity also with a colour map (" +
                        colour_map_ids() + ") and a range: b_factor,cividis,0:60"},
                   "element",
                   [&options](const std::string& text) {
                     options.ball_paint = paint_from(text, PaintTarget::balls, options.notes);
                   }),
      paint_option({display_field(&DisplaySettings::complex_paint).option.name, "PAINT",
                    "Colours of simplices: balls (as the balls, or one colour where that is "
                    "impossible), " +
                        scheme_ids(PaintTarget::simplices) + ", or a colour"},
                   "balls",
                   [&options](const std::string& text) {
                     options.simplex_paint.reset();
                     if (text != "balls") {
                       options.simplex_paint =
                           paint_from(text, PaintTarget::simplices, options.notes);
                     }
                   }),
      flag_option("--no-legend", "Leave out the legend of the colours", options.no_legend),
      text_option({"--beside", "KINDS",
                   "Kinds of atoms that are drawn although they are not part of the complex: " +
                       kinds_beside_body() + ", with commas; or none"},
                  options.beside),
      objects(options.objects),
      caption(options.caption),
      flag_option("--scale-bar", "Add a scale bar in Å", options.scale_bar),
      letters(options.letters),
      drawing_memory(options.drawing_memory_mb)};
  append(all, display_options(options.display));
  append(all, engine(options.request, true));
  append(all, input(options.input));
  return all;
}

Options source(ScreenshotCommandOptions& options) {
  return {one_file(options.input, false),
          path_option({"--session", "S.json",
                       "Session with molecule, settings and view, saved in the window; FILE "
                       "then replaces its molecule"},
                      options.session),
          not_required(alpha(options.request))};
}

// An option that sets `given` when it is present.
Option recorded(OptionText text, bool& given, std::function<void(const std::string&)> read) {
  Option option{
      .names = std::move(text.names), .value = std::move(text.value), .text = std::move(text.text)};
  option.set = [&given, read = std::move(read)](const std::string& value) {
    given = true;
    read(value);
  };
  return option;
}

Options recording(FramesCommandOptions& options) {
  Recording& r = options.recording;
  return {
      recorded({"--sweep", "alpha=FROM:TO:FRAMES",
                "Sweep of alpha in Å², with one complex in each frame, such as alpha=-1:10:120"},
               options.sweep, [&r](const std::string& text) { read_sweep(text, r); }),
      choice_option({"--sweep-scale", kScalings,
                     "Equal steps of alpha, of its signed square root, or of its logarithm "
                     "(linear within 0.01 Å² of 0)"},
                    options.scaling),
      recorded({"--turntable", "DEGREES:FRAMES",
                "Turntable: degrees and frames, such as 360:120; the camera keeps its distance"},
               options.turntable, [&r](const std::string& text) { read_turntable(text, r); }),
      choice_option({"--axis", kTurnAxes,
                     "Axis of the turntable, through the middle: upwards in the view, or an "
                     "axis of the file"},
                    options.axis),
      flag_option("--there-and-back", "Also play back to the beginning, for a loop",
                  r.there_and_back),
      number_option({"--fps", "N", "Frames per second of the movie"}, r.frames_per_second,
                    {kFrameRateRule.least, kFrameRateRule.most, "/ s"})};
}

bool has_no_background(const ScreenshotCommandOptions& options) {
  return options.transparent || (options.background && options.background->transparent);
}

void check_recording(FramesCommandOptions& options) {
  if (options.sweep == options.turntable) {
    throw std::invalid_argument(
        options.sweep ? "--sweep and --turntable cannot be combined; choose one of them"
                      : "--sweep or --turntable is required");
  }
  const auto& given = options.picture.beside_session;
  if (options.sweep && std::find(given.begin(), given.end(), "--alpha") != given.end()) {
    throw std::invalid_argument("--sweep sets alpha; leave --alpha out");
  }
  if (options.turntable && options.scaling != "linear") {
    throw std::invalid_argument("--sweep-scale belongs to --sweep");
  }
  if (options.sweep && options.axis != "up") {
    throw std::invalid_argument("--axis belongs to --turntable");
  }
  options.recording.scaling = scaling_from_id(options.scaling);
  options.recording.axis = turn_axis_from_id(options.axis);
  const std::filesystem::path& out = options.picture.out;
  const RecordingFormat format = recording_format(out);
  if (format == RecordingFormat::frames) FrameNames{out};
  if (format == RecordingFormat::mp4 && has_no_background(options.picture)) {
    throw std::invalid_argument(
        "an .mp4 movie always has a background; --transparent needs .webm or pictures");
  }
}

OptionCommand table_of_screenshot(ScreenshotCommandOptions& options) {
  OptionCommand command{"screenshot", "Draw the complex; needs no display", {}};
  command.options = source(options);
  command.options.push_back(
      required(path_option({"-o,--output", "OUT.png", "Picture to write"}, options.out)));
  append(command.options, picture_options(options));
  for (Option& option : command.options) note_what_sessions_say(option, options);
  command.check = [&options] {
    require_tuple_engine(options.request);
    require_one_source(options, true);
  };
  command.examples = {"alphascope-cli screenshot 1crn.pdb --alpha 1.4 --size 1920x1080 -o 1crn.png",
                      "alphascope-cli screenshot --session 1crn.json --size 1920x1080 -o 1crn.png"};
  return command;
}

OptionCommand table_of_frames(FramesCommandOptions& options) {
  OptionCommand command{
      "frames",
      "Draw a sweep of alpha or a turntable, as pictures or a movie; needs no display",
      {}};
  command.options = source(options.picture);
  command.options.push_back(
      required(path_option({"-o,--output", "OUT.EXT",
                            "Pictures (frame-%04d.png, counted from 1) or, where ffmpeg is "
                            "installed, a movie (.mp4, .webm)"},
                           options.picture.out)));
  append(command.options, picture_options(options.picture));
  for (Option& option : command.options) note_what_sessions_say(option, options.picture);
  const Options of_recording = recording(options);
  command.options.insert(command.options.begin() + 2, of_recording.begin(), of_recording.end());
  command.check = [&options] {
    require_tuple_engine(options.picture.request);
    check_recording(options);
    require_one_source(options.picture, options.turntable);
  };
  command.examples = {"alphascope-cli frames 1crn.pdb --sweep alpha=-1:10:120 -o 1crn-%04d.png",
                      "alphascope-cli frames 1crn.pdb --turntable 360:120 --alpha 1.4 -o 1crn.mp4"};
  return command;
}

}  // namespace

Command screenshot_command() {
  const auto options = std::make_shared<ScreenshotCommandOptions>();
  return {table_of_screenshot(*options), [options](const std::vector<std::string>& arguments) {
            options->arguments = arguments;
            return run_screenshot(*options);
          }};
}

Command frames_command() {
  const auto options = std::make_shared<FramesCommandOptions>();
  return {table_of_frames(*options), [options](const std::vector<std::string>& arguments) {
            options->picture.arguments = arguments;
            return run_frames(*options);
          }};
}

}  // namespace alphascope::cli
