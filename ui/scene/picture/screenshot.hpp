// A picture of a complex without a window or a display, for the command line and for figures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/session/session_file.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/scene/picture/picture.hpp"

namespace alphascope {

struct ScreenshotOptions {
  int width = 1280, height = 800;  // pixels, 16 to 16384
  bool transparent = false;        // no background
  bool legend = true;              // where colours mean something
  bool scale_bar = false;
  std::vector<std::string> caption;  // ui/caption.hpp; empty: none
  SceneStyle style;
  BallStyle balls;
  MeshOptions mesh;
  BallAppearance looks;               // hidden balls and colours of their own
  std::vector<Rgb8> simplex_colours;  // one a ball; empty: as the balls'
  // What they mean; none: nothing. Alpha values and classes of simplices explain themselves.
  std::optional<PaintKey> ball_key, simplex_key;
  std::optional<CameraPlace> camera;  // none: the default view
  std::optional<ClipWords> clip;      // none: whole
  Layers layers;                      // drawn beside balls and complex
  // Atoms that are no balls, made on the way; empty or null from it: none.
  std::function<std::shared_ptr<const LayerMesh>(const BallGeometry& balls)> beside_body;
  PictureTexts texts;                       // into the file
  std::optional<std::uint64_t> free_bytes;  // of memory; none: unknown
};

// Makes pictures of complexes of the same balls: of one, or of one after another.
class PictureMaker {
 public:
  // `balls`: with radii before any solvent; they must outlive it.
  explicit PictureMaker(const BallSet& balls) : balls_(balls) {}
  // One colour a ball. Options that follow the complex (texts, caption, radii of grown balls) are
  // those of `options` now. Throws as render_screenshot().
  Picture make(const AlphaComplex& complex, const std::vector<Rgb8>& colours,
               const ScreenshotOptions& options, const RunContext& context);

 private:
  const BallSet& balls_;
  std::shared_ptr<const BallGeometry> geometry_;  // made with the first picture, as the next is
  std::shared_ptr<const LayerMesh> beside_body_;
};

// Needs no display: makes its own OpenGL context on this thread. Returns what is not drawn for want
// of memory, and what to do, in sentences that the file holds, too, and which mark the picture is
// too small for; empty: nothing is missing. Throws std::runtime_error when OpenGL is missing or the
// file cannot be written; Cancelled between its steps, and then writes nothing.
std::string render_picture(const Picture& picture, const std::filesystem::path& path,
                           const RunContext& context = {});

// Of `complex` with its `balls` (radii before any solvent; one colour each). Also throws
// std::invalid_argument for sizes out of range or input that does not belong together, and
// std::runtime_error when there is no memory for any picture.
std::string render_screenshot(const BallSet& balls, const AlphaComplex& complex,
                              const std::vector<Rgb8>& colours, const ScreenshotOptions& options,
                              const std::filesystem::path& path, const RunContext& context = {});

}  // namespace alphascope
