// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli frames: draws a sweep of alpha or a turntable as numbered pictures or a
// movie. Part of the program that start_screenshot.cpp starts.
#include <iostream>

#include "app/cli/outputs.hpp"
#include "app/cli/pictures/cli_pictures.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/text/printable.hpp"
#include "core/write/movie_file.hpp"
#include "ui/scene/picture/record_frames.hpp"

namespace alphascope::cli {
namespace {

// Refuses frames whose names would replace an input file.
void refuse_clashes(const FramesCommandOptions& options, const Outputs& outputs) {
  const std::filesystem::path& out = options.picture.out;
  if (recording_format(out) != RecordingFormat::frames) {
    outputs.refuse_clash("--output", out);
    return require_ffmpeg();
  }
  const FrameNames names(out);
  for (int k = 1; k <= frame_count(options.recording); ++k) {
    outputs.refuse_clash("--output", names.name(k));
  }
}

std::string frame_text(const FrameReport& news, const Recording& recording) {
  const bool sweep = recording.kind == RecordingKind::sweep;
  return "frame " + std::to_string(news.number) + " of " + std::to_string(news.of) + ", " +
         (sweep ? "alpha " + shortest_number(news.alpha_angstrom2) + " Å²"
                : "turned by " + format_text("%.2f", news.degrees) + "°") +
         ": computed in " + milliseconds_text(news.make_milliseconds) + ", drawn in " +
         milliseconds_text(news.draw_milliseconds) + ", written in " +
         milliseconds_text(news.write_milliseconds);
}

std::string recording_text(const Recording& r) {
  const std::string what =
      r.kind == RecordingKind::sweep
          ? "alpha from " + shortest_number(r.low) + " to " + shortest_number(r.high) + " Å²"
          : "turned by " + shortest_number(r.degrees) + "° about " +
                (r.axis == TurnAxis::up ? "the view's upward axis"
                                        : std::string(turn_axis_id(r.axis)));
  return what + (r.there_and_back ? ", there and back" : "");
}

// Ends a cancelled run that writes pictures. Finished pictures stay.
ExitCode cancelled_after(int finished) {
  clear_progress();
  if (verbosity() != Verbosity::quiet) {
    std::cerr << "alphascope-cli: cancelled; " << finished
              << (finished == 1 ? " frame is" : " frames are") << " finished.\n";
  }
  return static_cast<ExitCode>(cancelled_status());
}

}  // namespace

ExitCode run_frames(const FramesCommandOptions& options) {
  const RunContext& context = run_context();
  const Recording& recording = options.recording;
  const std::filesystem::path& out = options.picture.out;
  const Outputs outputs(files_of_picture(options.picture));
  refuse_clashes(options, outputs);
  CommandLinePictures cli_pictures(options.picture, context);
  refuse_clashes(options, outputs);  // the session's molecule has been read by now
  const PictureOptions& picture = cli_pictures.options();
  FrameSource source;
  source.picture = [&](std::optional<double> alpha, const RunContext& quiet) {
    return cli_pictures.picture(cli_pictures.compute(alpha, quiet), quiet);
  };
  int finished = 0;
  source.on_frame = [&](const FrameReport& news) {
    finished = news.number;
    if (verbosity() != Verbosity::verbose) return;
    std::cerr << "alphascope-cli: " << frame_text(news, recording) << "\n";
  };
  const auto sink =
      make_frame_sink(out, {picture.width, picture.height, recording.frames_per_second,
                            picture.background.transparent, cli_pictures.texts(),
                            frame_count(recording), picture.dpi});
  const bool movie = recording_format(out) != RecordingFormat::frames;
  std::string lacks;
  try {
    lacks = record_frames(recording, source, *sink, context);
    sink->commit(context);
  } catch (const Cancelled&) {
    if (movie || finished == 0) throw;
    return cancelled_after(finished);
  }
  clear_progress();
  if (!lacks.empty()) std::cerr << "alphascope-cli: " << lacks << "\n";
  std::cout << input_text(cli_pictures.input()) << "recording   " << recording_text(recording)
            << "\n"
            << (movie ? "movie       " : "pictures    ") << printable(out.string()) << ", "
            << frame_count(recording) << (frame_count(recording) == 1 ? " frame, " : " frames, ")
            << picture.width << " x " << picture.height;
  if (movie) std::cout << ", " << format_text("%.1f", seconds_of(recording)) << " s";
  std::cout << "\n";
  return ExitCode::ok;
}

}  // namespace alphascope::cli
