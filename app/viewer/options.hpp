// SPDX-License-Identifier: GPL-3.0-or-later
// The command-line options of alphascope, the program with the window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/document/fetch/molecule_id.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope {

struct ViewerOptions {
  std::optional<std::filesystem::path> file, session;
  std::optional<MoleculeId> id;               // in place of `file`
  bool offline = false, fetch_again = false;  // for ids; again: for `id` only
  Alpha alpha;                                // Å²
  double solvent = 0;                         // Å
  double scale = 0;                           // 0: the scale of the display
  int width = 0, height = 0;                  // pixels at scale 1; 0: the last size
  bool light = false;
  std::string preset;                   // id of a DisplayPreset, or none
  std::optional<DrawnObjects> objects;  // of an opened molecule; none: usual_objects()
  std::optional<int> samples;  // samples a pixel in pictures at rest; none: the preset's number
  bool tetrahedra_only = false;
  bool compare = true;
  std::optional<std::filesystem::path> script, shot;
  std::string lesson;  // a name or a path; empty: none
  // Path: the lesson is recorded as pictures or a movie, then the program exits.
  std::optional<std::filesystem::path> record;
  double record_seconds = 10;  // time for each step
  int record_width = 1280, record_height = 720;
  // Folder of the preferences. Empty: preferences are neither read nor written.
  std::filesystem::path preferences;
  bool preferences_given = false;
  bool script_help = false;   // print the help on scripts, then exit
  bool display_help = false;  // print the settings of the display, then exit
  // For a hidden window: panels are drawn only in frames that become a saved picture.
  bool draw_shots_only = false;
  // Assumed free memory for drawing, 10^6 bytes. None: the measured value.
  std::optional<std::uint64_t> drawing_memory_mb;
};

struct ParsedOptions {
  ViewerOptions options;
  std::optional<int> exit_code;  // set when the program has to exit at once, after printing `text`
  std::string text;
};

ParsedOptions parse_options(int argc, const char* const* argv);

}  // namespace alphascope
