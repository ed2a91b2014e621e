// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `screenshot` and `frames`. run_screenshot() and run_frames() either draw, or start
// the program that has the renderer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/exit_code.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/picture_options.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/reference/annotations.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/document/settings/paint.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope::cli {

// The given options that change a setting of the display, in their order, and the values. All other
// settings are those of the preset or, without one, the window's default.
inline constexpr const char* kUsualSize = "1280x800";
using DisplayChanges = std::vector<std::pair<const DisplayField*, double>>;

struct ScreenshotCommandOptions {
  InputOptions input;
  Request request;
  std::string size;  // empty: the preset's, or kUsualSize
  std::filesystem::path out;
  std::optional<int> dpi;                       // none: the preset's, or the usual
  std::optional<PictureBackground> background;  // none: the preset's, or the theme's
  std::optional<double> letters;                // none: the preset's, or 1
  bool transparent = false, light = false;
  DisplayChanges display;
  Paint ball_paint{ColourBy::element, {}, {}, {}};
  std::optional<Paint> simplex_paint;  // none: the paint of the balls
  bool no_legend = false, scale_bar = false;
  CaptionParts caption;
  std::string preset;  // id of a DisplayPreset; empty: none
  AppearanceWords appearance;
  AnnotationWords annotations;
  DrawnObjects objects;
  std::string clip = "off";             // as for read_clip()
  std::string beside = "ligands,ions";  // kinds of AtomsBesideBody, or "none"
  // Assumed free memory for drawing, 10^6 bytes. None: the measured value.
  std::optional<std::uint64_t> drawing_memory_mb;
  std::filesystem::path session;            // empty: no session; otherwise input.file may be empty
  std::vector<std::string> beside_session;  // given options that the session would set
  std::vector<std::string> notes;           // sentences on former names among the options
  std::vector<std::string> arguments;       // as given, for the program that draws
};

struct FramesCommandOptions {
  ScreenshotCommandOptions picture;  // for each frame; its `out` names all frames, or the movie
  Recording recording;
  bool sweep = false, turntable = false;        // which of the two was requested
  std::string scaling = "linear", axis = "up";  // kScalings, kTurnAxes
  FramesCommandOptions() { picture.caption = usual_caption(); }
};

ExitCode run_screenshot(const ScreenshotCommandOptions& options);
ExitCode run_frames(const FramesCommandOptions& options);

}  // namespace alphascope::cli
