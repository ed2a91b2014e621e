// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the command line, of one complex or of several in turn. Options or a session set
// their contents. Part of the program that start_screenshot.cpp starts.
#pragma once

#include <optional>

#include "app/cli/input.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "app/session/engine_cache.hpp"
#include "core/document/reference/annotations.hpp"
#include "ui/scene/picture/picture_maker.hpp"

namespace alphascope::cli {

class CommandLinePictures {
 public:
  // Opens the molecule. Throws UsageError and ReadError.
  CommandLinePictures(const ScreenshotCommandOptions& options, const RunContext& context);
  CommandLinePictures(const CommandLinePictures&) = delete;
  CommandLinePictures& operator=(const CommandLinePictures&) = delete;

  const Input& input() const { return input_; }
  const PictureOptions& options() const { return picture_.options; }
  // Computes the complex at this alpha (Å²). Without a value, the options' or the session's alpha
  // is used.
  std::shared_ptr<const EngineAnswer> compute(std::optional<double> alpha,
                                              const RunContext& context);
  Picture picture(const std::shared_ptr<const EngineAnswer>& answer, const RunContext& context);
  // Texts common to all pictures: program, molecule, radii and the command line.
  PictureTexts texts() const;

 private:
  void follow_options(const ScreenshotCommandOptions& options, const RunContext& context);
  void follow_session(const ScreenshotCommandOptions& options, const RunContext& context);
  std::shared_ptr<const Layer> annotation_layer() const;

  Input input_;
  Request request_;
  Annotations annotations_;
  PictureSettings picture_;
  std::string command_;  // the command that makes the same picture
  std::string told_;     // the last note on missing colours
  EngineCache engines_{&make_engine};
  std::optional<PictureMaker> maker_;
};

// The input files of a picture, which no output may replace. Throws ReadError for an unreadable
// one.
std::vector<std::filesystem::path> files_of_picture(const ScreenshotCommandOptions& options);

}  // namespace alphascope::cli
