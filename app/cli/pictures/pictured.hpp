// What the pictures of the command line show, by options or by a session: of one complex, or of one
// after another. Part of the program that start_screenshot.cpp starts.
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
  // Of alpha (Å²), or of the one that options or session say.
  std::shared_ptr<const EngineAnswer> compute(std::optional<double> alpha,
                                              const RunContext& context);
  Picture picture(const EngineAnswer& answer, const RunContext& context);
  // Of all of them: program, molecule, radii and the command line.
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
  std::string command_;  // that makes it again
  std::string told_;     // what the colours lack
  std::optional<std::uint64_t> drawing_memory_mb_;
  EngineCache engines_{&make_engine};
  std::optional<PictureMaker> maker_;
};

// Files that a picture reads, which no output may replace. Throws ReadError for those that cannot
// be read.
std::vector<std::filesystem::path> files_of_picture(const ScreenshotCommandOptions& options);

}  // namespace alphascope::cli
