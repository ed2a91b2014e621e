// What `screenshot` and `frames` are asked, and who draws: this program or the one with the
// renderer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/exit_code.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/reference/annotations.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/settings/paint.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope::cli {

struct ScreenshotCommandOptions {
  InputOptions input;
  Request request;
  std::string size = "1280x800";
  std::filesystem::path out;
  bool transparent = false, light = false, no_balls = false, grown = false, boundary = false;
  double shrink = 0;
  Paint ball_paint{ColourBy::element, {}, {}, {}};
  std::optional<Paint> simplex_paint;  // none: as the balls
  bool no_legend = false, scale_bar = false;
  CaptionParts caption;
  bool orthographic = false;
  std::string preset;  // id of a DisplayPreset, or none
  bool no_shadows = false;
  // None: the preset's, or the window's.
  std::optional<double> depth_cue, outlines, face_lines, edge_thickness, samples;
  bool smooth = false;  // the boundary
  AppearanceWords appearance;
  AnnotationWords annotations;
  std::string clip = "off";                        // as read_clip() takes it
  std::string beside = "ligands,ions";             // kinds of AtomsBesideBody, or "none"
  std::optional<std::uint64_t> drawing_memory_mb;  // taken as free; none: what is
  std::filesystem::path session;                   // empty: none; else input.file may be empty
  std::vector<std::string> beside_session;         // options that a session says itself
  std::vector<std::string> arguments;              // as given, for the program that draws
};

struct FramesCommandOptions {
  ScreenshotCommandOptions picture;  // of each frame; its `out` names all of them, or a movie
  Recording recording;
  bool sweep = false, turntable = false;        // which was asked for
  std::string scaling = "linear", axis = "up";  // kScalings, kTurnAxes
  FramesCommandOptions() { picture.caption = usual_caption(); }
};

ExitCode run_screenshot(const ScreenshotCommandOptions& options);
ExitCode run_frames(const FramesCommandOptions& options);

}  // namespace alphascope::cli
