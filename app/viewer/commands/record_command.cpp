// SPDX-License-Identifier: GPL-3.0-or-later
// The command that records a sweep of alpha, a turntable or the open lesson.
#include <filesystem>
#include <stdexcept>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/frame_names.hpp"
#include "core/document/picture/picture_options.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/lessons/lesson_state.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

// Without a path the dialog asks for all parameters.
Outcome record(const Arguments& arguments, ViewState& s, const Calls& ask) {
  RecordState& m = s.record;
  if (!arguments.has("path")) {
    m.show = true;
    return {};
  }
  std::error_code ignored;
  RecordRequest request{
      std::filesystem::absolute(arguments.text("path"), ignored).lexically_normal(), m.recording,
      m.options};
  try {
    const RecordingFormat format = recording_format(request.path);
    if (format == RecordingFormat::frames) FrameNames{request.path};
    const std::string what = arguments.text("what");
    if (what.starts_with("lesson")) {
      request.lesson_seconds = read_lesson_recording(what);
    } else if (what.starts_with("alpha")) {
      read_sweep(what, request.recording);
    } else if (!what.empty()) {
      read_turntable(what, request.recording);
    }
    if (arguments.has("caption")) {
      request.options.caption = read_caption_parts(arguments.text("caption"));
    }
  } catch (const std::invalid_argument& error) {
    return Outcome::refused("The recording is impossible: " + std::string(error.what()) + ".");
  }
  if (request.lesson_seconds && !s.lessons.open) {
    return Outcome::refused("No lesson is open.");
  }
  if (!request.lesson_seconds && !s.result) return Outcome::refused("There is no complex yet.");
  PictureOptions& options = request.options;
  options.width = static_cast<int>(arguments.number("width", options.width));
  options.height = static_cast<int>(arguments.number("height", options.height));
  request.recording.frames_per_second =
      arguments.number("rate", request.recording.frames_per_second);
  request.recording.there_and_back |= arguments.has("there-and-back");
  if (arguments.has("transparent")) options.background = kNoBackground;
  options.scale_bar |= arguments.has("scale-bar");
  ask.jobs.record(std::move(request));
  return {};
}

}  // namespace

CommandSpec record_command(ViewState& s, const Calls& ask) {
  const auto number = [](const char* name, const char* help, const NumberRule& rule) {
    return Parameter{
        .name = name, .kind = Kind::number, .help = help, .optional = true, .rule = rule};
  };
  return {
      .id = "file.record",
      .title = "Record…",
      .help = "Writes a sweep of alpha, a turntable or the open lesson as pictures or a movie",
      .synonyms = {{"movie video film animation turntable"}},
      .shortcuts = {{"Ctrl+Shift+R"}},
      .menu = "File",
      .parameters =
          {{.name = "path",
            .kind = Kind::path,
            .help = "Pictures (frame-%04d.png) or, where ffmpeg is installed, a movie (.mp4, "
                    ".webm); if left out, a dialog opens",
            .optional = true},
           {.name = "what",
            .kind = Kind::text,
            .help =
                "A sweep in Å² and its frames, a turntable in degrees and its frames (360:120), "
                "or the open lesson and the seconds of each of its steps (lesson:10)",
            .example = "alpha=-1:10:120",
            .optional = true},
           number("width", "Width in pixels; if left out, as in the dialog", kPictureSizeRule),
           number("height", "Height in pixels; if left out, as in the dialog", kPictureSizeRule),
           {.name = "caption",
            .kind = Kind::text,
            .help = "Parts of the caption, as of file.save_picture",
            .example = "alpha,counts",
            .optional = true},
           number("rate", "Frames a second, of a movie", kFrameRateRule),
           {.name = "there-and-back",
            .kind = Kind::flag,
            .help = "Also plays back to the beginning, for a loop"},
           {.name = "transparent", .kind = Kind::flag, .help = "Without background"},
           {.name = "scale-bar", .kind = Kind::flag, .help = "With a scale bar"}},
      .why_not =
          [&s] {
            const bool any = s.result || s.lessons.open;
            return any ? "" : "There is no complex yet, and no lesson is open.";
          },
      .run = [&s, ask](const Arguments& arguments) { return record(arguments, s, ask); }};
}

}  // namespace alphascope
