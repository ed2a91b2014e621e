// The pictures of the command line, of one complex or of several in turn. Options or a session set
// their contents. Part of the program that start_screenshot.cpp starts.
#pragma once

#include <optional>

#include "app/cli/input.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "app/session/engine_cache.hpp"
#include "core/document/measures/paint_balls.hpp"
#include "ui/scene/mesh/beside_body.hpp"
#include "ui/scene/picture/screenshot.hpp"

namespace alphascope::cli {

class Pictured {
 public:
  // Opens the molecule. Throws UsageError and ReadError.
  Pictured(const ScreenshotCommandOptions& options, const RunContext& context);
  Pictured(const Pictured&) = delete;
  Pictured& operator=(const Pictured&) = delete;

  const Input& input() const { return input_; }
  const ScreenshotOptions& options() const { return picture_; }
  // The complex at this alpha (Å²). Without one, at that of the options or the session.
  std::shared_ptr<const EngineAnswer> compute(std::optional<double> alpha,
                                              const RunContext& context);
  Picture picture(const EngineAnswer& answer, const RunContext& context);
  // Texts common to all pictures: program, molecule, radii and the command line.
  PictureTexts texts() const;

 private:
  void follow_options(const ScreenshotCommandOptions& options, const RunContext& context);
  void follow_session(const ScreenshotCommandOptions& options, const RunContext& context);
  PaintedBalls painted_by(const Paint& paint, const EngineAnswer& answer,
                          const RunContext& context) const;
  std::shared_ptr<const Layer> annotation_layer() const;
  // Returns the colours of the balls.
  std::vector<Rgb8> follow_answer(const EngineAnswer& answer, const RunContext& context);
  std::vector<Rgb8> follow_colours(const EngineAnswer& answer, const RunContext& context);

  Input input_;
  Request request_;
  DisplayControls display_;
  Theme theme_ = Theme::dark;
  Appearance appearance_;
  Annotations annotations_;
  ScreenshotOptions picture_;
  CaptionParts caption_;
  std::string command_;  // the command that makes the same picture
  std::string told_;     // the last note on missing colours
  std::optional<std::uint64_t> drawing_memory_mb_;
  EngineCache engines_{&make_engine};
  std::optional<PictureMaker> maker_;
};

// The input files of a picture, which no output may replace. Throws ReadError for an unreadable
// one.
std::vector<std::filesystem::path> files_of_picture(const ScreenshotCommandOptions& options);

}  // namespace alphascope::cli
