// A picture of a complex without a window or a display, for the command line and for figures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/appearance.hpp"
#include "core/document/session_file.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/scene/frame_grab.hpp"

namespace alphascope {

struct ScreenshotOptions {
  int width = 1280, height = 800;  // pixels, 16 to 16384
  bool transparent = false;        // no background
  bool legend = true;              // where colours are of alpha values
  bool scale_bar = false;
  SceneStyle style;
  BallStyle balls;
  MeshOptions mesh;
  BallAppearance looks;                     // hidden balls and colours of their own
  std::vector<Rgb8> simplex_colours;        // one a ball; empty: as the balls'
  std::optional<ColourLegend> ball_legend;  // of the balls' colours; none: of the simplices'
  std::optional<CameraPlace> camera;        // none: the default view
  std::optional<ClipWords> clip;            // none: whole
  Layers layers;                            // drawn beside balls and complex
  // Atoms that are no balls, made on the way; empty or null from it: none.
  std::function<std::shared_ptr<const LayerMesh>(const BallGeometry& balls)> beside_body;
  PictureTexts texts;                       // into the file
  std::optional<std::uint64_t> free_bytes;  // of memory; none: unknown
};

// Draws `complex` with its `balls` (radii before any solvent; one colour each).
// Needs no display: makes its own OpenGL context on this thread. Returns what is not drawn for want
// of memory, and what to do, in sentences that the file holds, too, and which mark the picture is
// too small for; empty: nothing is missing.
// Throws std::invalid_argument for sizes out of range or input that does not belong together,
// std::runtime_error when OpenGL is missing, the file cannot be written, or there is no memory for
// any picture; Cancelled between its steps, and then writes nothing.
std::string render_screenshot(const BallSet& balls, const AlphaComplex& complex,
                              const std::vector<Rgb8>& colours, const ScreenshotOptions& options,
                              const std::filesystem::path& path, const RunContext& context = {});

}  // namespace alphascope
