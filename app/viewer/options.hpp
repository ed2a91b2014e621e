// The command line of alphascope.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/geometry/alpha.hpp"

namespace alphascope {

struct ViewerOptions {
  std::optional<std::filesystem::path> file, session;
  Alpha alpha;                // Å²
  double solvent = 0;         // Å
  double scale = 0;           // 0: as the display says
  int width = 0, height = 0;  // at scale 1; 0: as last time
  bool light = false;
  std::string preset;          // id of a DisplayPreset, or none
  std::optional<int> samples;  // a pixel of pictures at rest; none: the preset's
  bool tetrahedra_only = false;
  bool compare = true;
  std::optional<std::filesystem::path> script, shot;
  std::string lesson;                           // a name or a path; empty: none
  std::optional<std::filesystem::path> record;  // the lesson, as pictures or a movie, and end
  double record_seconds = 10;                   // of each step
  int record_width = 1280, record_height = 720;
  // Folder of preferences; empty: they are neither read nor written.
  std::filesystem::path preferences;
  bool preferences_given = false;
  bool script_help = false;  // print what scripts may contain, and end
  // Of a window that nobody sees: panels of a frame that no picture is taken of are not drawn.
  bool draw_shots_only = false;
  std::optional<std::uint64_t> drawing_memory_mb;  // taken as free; none: what is
};

struct ParsedOptions {
  ViewerOptions options;
  std::optional<int> exit_code;  // set when the program should end at once, after printing `text`
  std::string text;
};

ParsedOptions parse_options(int argc, const char* const* argv);

}  // namespace alphascope
