// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the window's command-line options. app/options parses it.
#include "app/viewer/options.hpp"

#include <sstream>
#include <stdexcept>

#include "app/options/exit_code.hpp"
#include "app/options/fetch_flags.hpp"
#include "app/options/manual_entries.hpp"
#include "app/options/option_values.hpp"
#include "app/options/parse_arguments.hpp"
#include "app/viewer/script/script.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/picture/frame_names.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/settings/display_help.hpp"
#include "core/files/output_ending.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/read/file_format.hpp"

namespace alphascope {
namespace {

constexpr int kLeastSize = 640, kMostSize = 8192;

// Reads "1280x800" into width and height. False: the text has another form.
bool read_size(const std::string& text, int& width, int& height) {
  char x = 0;
  std::istringstream stream(text);
  stream.exceptions(std::ios::badbit);
  return stream >> width >> x >> height && (x == 'x' || x == 'X') && stream.peek() == EOF;
}

// Checks the size of the window. Throws std::invalid_argument.
void set_size(const std::string& text, int& width, int& height) {
  if (read_size(text, width, height) && std::min(width, height) >= 480 && width >= kLeastSize &&
      std::max(width, height) <= kMostSize) {
    return;
  }
  throw std::invalid_argument("\"" + text +
                              "\" is not a valid size; write WIDTHxHEIGHT from 640x480 to "
                              "8192x8192, such as 1280x800");
}

template <class Target>
Option path_or_none(OptionText text, Target& target) {
  Option option{
      .names = std::move(text.names), .value = std::move(text.value), .text = std::move(text.text)};
  option.set = [&target](const std::string& path) { target = path; };
  return option;
}

Option file_option(ViewerOptions& options) {
  Option file{.names = "FILE",
              .value = "FILE",
              .text = "Molecule: " + format_names() +
                      "; also as .gz; a session (.json); or an id that is fetched: pdb:1CRN, "
                      "af:P69905"};
  file.set = [&options](const std::string& typed) {
    options.id = molecule_id_unless_file(typed);
    if (!options.id) options.file = typed;
  };
  return file;
}

Option size_option(ViewerOptions& options) {
  Option size{.names = "--size",
              .value = "WxH",
              .text = "Width and height of the window in pixels, at scale 1",
              .fallback = "the last size; at first 1440x900"};
  size.set = [&options](const std::string& text) { set_size(text, options.width, options.height); };
  return size;
}

// Checks the size of recorded pictures.
Option record_size_option(ViewerOptions& o) {
  Option size{.names = "--record-size",
              .value = "WxH",
              .text = "Width and height of a recorded lesson in pixels",
              .fallback = "1280x720"};
  size.set = [&o](const std::string& text) {
    const auto within = [](int pixels) {
      return pixels >= kPictureSizeRule.least && pixels <= kPictureSizeRule.most;
    };
    if (read_size(text, o.record_width, o.record_height) && within(o.record_width) &&
        within(o.record_height)) {
      return;
    }
    throw std::invalid_argument("\"" + text +
                                "\" is not a valid size; write WIDTHxHEIGHT, such as 1280x720");
  };
  return size;
}

Option objects_option(ViewerOptions& options) {
  return {.names = "--objects",
          .value = "LIST",
          .text = "Objects of a molecule that is opened, as for alphascope-cli screenshot; or none",
          .fallback = "a cartoon and the ligands",
          .set = [&options](const std::string& text) {
            ObjectListWords words = read_objects(text);
            if (!words.error.empty()) throw std::invalid_argument(words.error);
            options.objects = std::move(words.objects);
          }};
}

Option script_option(ViewerOptions& options) {
  Option script = path_or_none(
      {"--script", "FILE", "Drive the window by the commands in this file"}, options.script);
  script.set = [&options](const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
      throw std::invalid_argument(error ? "cannot open " + path + ": " + error.message()
                                        : "there is no file " + path);
    }
    options.script = path;
  };
  return script;
}

// The options below check the name of their output before anything is computed.
Option shot_option(ViewerOptions& options) {
  Option shot = path_or_none(
      {"--shot", "OUT.png", "Write a picture of the window and exit; needs no display"},
      options.shot);
  shot.set = [&options](const std::string& path) {
    const std::string fault = fault_of_ending(path, {".png"});
    if (!fault.empty()) throw std::invalid_argument(path + ": " + fault);
    options.shot = path;
  };
  return shot;
}

Option record_option(ViewerOptions& options) {
  Option record = path_or_none({"--record", "OUT",
                                "Record the lesson as pictures (step-%02d.png) or a movie (.mp4, "
                                ".webm) and exit; needs no display"},
                               options.record);
  record.set = [&options](const std::string& path) {
    if (recording_format(path) == RecordingFormat::frames) FrameNames{path};
    options.record = path;
  };
  return record;
}

Option drawing_memory_option(ViewerOptions& options) {
  Option memory{.names = "--drawing-memory",
                .value = "MB",
                .text = "Assume this much free memory for drawing, in MB",
                .fallback = "measured"};
  memory.set = [&options](const std::string& value) {
    options.drawing_memory_mb =
        static_cast<std::uint64_t>(whole_number_in(value, {0, 2'000'000'000, "MB"}));
  };
  return memory;
}

Option preferences_option(ViewerOptions& options) {
  Option folder{.names = "--preferences",
                .value = "FOLDER",
                .text = "Folder for preferences and recent files; none: do not keep them",
                .fallback = "~/.config/alphascope; none with --script, --shot and --record"};
  folder.set = [&options](const std::string& path) {
    options.preferences = path == "none" ? "" : path;
    options.preferences_given = true;
  };
  return folder;
}

Option lesson_option(ViewerOptions& options) {
  Option lesson{.names = "--lesson",
                .value = "NAME",
                .text = "Open a lesson by its name, or by the path of its file"};
  lesson.set = [&options](const std::string& name) { options.lesson = name; };
  return lesson;
}

// Reads the number as the fields of the window do.
Option typed_number_option(OptionText text, double& target, const NumberRule& rule) {
  Option option = number_option(std::move(text), target, {rule.least, rule.most, rule.unit});
  option.set = [&target, rule](const std::string& value) {
    const NumberInput input = read_number(value, rule);
    if (!input.value) throw std::invalid_argument(input.error);
    target = *input.value;
  };
  return option;
}

Option alpha_option(Alpha& target) {
  Option option{.names = "--alpha",
                .value = "A",
                .text = "Alpha in Å²; it may be negative",
                .fallback = "0 Å²"};
  option.set = [&target](const std::string& value) {
    const AlphaInput input = read_alpha(value);
    if (!input.value) throw std::invalid_argument(input.error);
    target = *input.value;
  };
  return option;
}

OptionProgram table(ViewerOptions& o) {
  OptionProgram program;
  program.name = "alphascope";
  program.text = "The exact alpha complex of a molecule, live, in a window";
  program.version = ALPHASCOPE_VERSION;
  program.usage_exit_code = static_cast<int>(ExitCode::usage);
  program.options = {
      file_option(o),
      path_or_none({"--session", "S.json", "Open a session, whatever the file's name"}, o.session),
      alpha_option(o.alpha),
      typed_number_option({"--solvent", "S", "Solvent radius in Å, 1.4 for water"}, o.solvent,
                          kSolventRule),
      with_default(typed_number_option({"--scale", "X", "Size of fonts and controls, 1 for 100 %"},
                                       o.scale, kControlScaleRule),
                   "scale of the display"),
      size_option(o),
      flag_option("--light", "Light theme", o.light),
      with_default(
          choice_option({"--preset", preset_ids(), "Preset of the picture's look"}, o.preset),
          "none"),
      objects_option(o),
      flag_option("--tetrahedra-only", "Compute only tetrahedra", o.tetrahedra_only),
      flag_option("--no-compare", "Do not compare with CGAL after each change", o.compare, false),
      offline_option(o.offline),
      fetch_again_option(o.fetch_again),
      preferences_option(o),
      drawing_memory_option(o),
      lesson_option(o),
      record_option(o),
      with_default(typed_number_option({"--record-seconds", "S", "Time of each step in a movie"},
                                       o.record_seconds, kHoldRule),
                   "10"),
      record_size_option(o),
      script_option(o),
      flag_option("--script-help", "List the commands of scripts and exit", o.script_help),
      flag_option("--display-help", "List the settings of the section Display and exit",
                  o.display_help),
      shot_option(o)};
  program.notes = {
      {"Examples",
       {"alphascope 4hhb.pdb.gz --alpha 1.4", "alphascope pdb:4HHB",
        "alphascope 4hhb.pdb.gz --solvent 1.4 --shot picture.png   (needs no display)",
        "alphascope --lesson union_of_balls --record union_of_balls.mp4   (needs no display)"}},
      {"Exit codes", exit_code_lines()}};
  add_standard_options(program);
  add_manual_entries(program);
  return program;
}

// A sentence if options do not fit together; else empty.
std::string contradiction(const ViewerOptions& options) {
  if (options.record && options.lesson.empty()) {
    return "--record records a lesson; name it with --lesson.";
  }
  return options.offline && options.fetch_again ? kOfflineAndAgain : "";
}

}  // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
  ParsedOptions parsed;
  ViewerOptions options;
  const ParsedArguments arguments = parse_arguments(table(options), argc, argv);
  const std::string fault = arguments.ended ? "" : contradiction(options);
  if (!fault.empty()) {
    parsed.exit_code = static_cast<int>(ExitCode::usage);
    parsed.text = "alphascope: " + fault + "\n";
    return parsed;
  }
  parsed.options = options;
  if (arguments.ended) {
    parsed.exit_code = arguments.exit_code;
    parsed.text = arguments.text;
  } else if (options.script_help) {
    parsed.exit_code = 0;
    parsed.text = script_help();
  } else if (options.display_help) {
    parsed.exit_code = 0;
    parsed.text = display_help();
  }
  return parsed;
}

}  // namespace alphascope
