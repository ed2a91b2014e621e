// Pictures of a complex without a window or a display, for the command line and for figures.
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
  bool legend = true;              // if colours have a meaning
  bool scale_bar = false;
  std::vector<std::string> caption;  // ui/caption.hpp; empty: none
  SceneStyle style;
  BallStyle balls;
  MeshOptions mesh;
  BallAppearance looks;               // hidden balls, and colours of single balls
  std::vector<Rgb8> simplex_colours;  // one a ball; empty: colours of the balls
  // Meaning of the colours; none: they have no meaning. Colours of alpha values and classes need no
  // key here.
  std::optional<PaintKey> ball_key, simplex_key;
  std::optional<CameraPlace> camera;  // none: the default view
  std::optional<ClipWords> clip;      // none: nothing is cut
  Layers layers;                      // drawn beside balls and complex
  // Makes the atoms that are not balls; if it is empty or returns null, none are drawn.
  std::function<std::shared_ptr<const LayerMesh>(const BallGeometry& balls)> beside_body;
  PictureTexts texts;                       // written into the file
  std::optional<std::uint64_t> free_bytes;  // of memory; none: unknown
};

// Makes pictures of one or more complexes of the same balls.
class PictureMaker {
 public:
  // `balls` have radii without solvent. They must outlive this object.
  explicit PictureMaker(const BallSet& balls) : balls_(balls) {}
  // `colours` has one colour for each ball. Texts, caption and radii of grown balls depend on the
  // complex. So `options` must be up to date in each call. Throws as render_screenshot() does.
  Picture make(const AlphaComplex& complex, const std::vector<Rgb8>& colours,
               const ScreenshotOptions& options, const RunContext& context);

 private:
  const BallSet& balls_;
  std::shared_ptr<const BallGeometry> geometry_;  // made with the first picture; so is the next
  std::shared_ptr<const LayerMesh> beside_body_;
};

// Draws a picture into a file. It needs no display, since it makes an OpenGL context on this
// thread. Returns sentences on parts and marks that are missing for lack of memory or room, with a
// remedy; empty: none. The file holds those on memory too. Throws std::runtime_error if OpenGL is
// missing or the file cannot be written. Throws Cancelled between its steps, and then writes
// nothing.
std::string render_picture(const Picture& picture, const std::filesystem::path& path,
                           const RunContext& context = {});

// Draws `complex` with its `balls` (radii without solvent; one colour each). Also throws
// std::invalid_argument for sizes out of range or inputs that do not fit together. Also throws
// std::runtime_error if memory is too small for any picture.
std::string render_screenshot(const BallSet& balls, const AlphaComplex& complex,
                              const std::vector<Rgb8>& colours, const ScreenshotOptions& options,
                              const std::filesystem::path& path, const RunContext& context = {});

}  // namespace alphascope
