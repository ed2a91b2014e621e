// A scene in an EGL context, one frame, a file.
#include "ui/scene/screenshot.hpp"

#include <stdexcept>

#include "ui/window/egl_context.hpp"

namespace alphascope {

void render_screenshot(const BallSet& balls, const AlphaComplex& complex,
                       const std::vector<Rgb8>& colours, const ScreenshotOptions& options,
                       const std::filesystem::path& path) {
  constexpr int kLeast = 16, kMost = 16384;
  if (options.width < kLeast || options.width > kMost || options.height < kLeast ||
      options.height > kMost) {
    throw std::invalid_argument("screenshot size " + std::to_string(options.width) + "x" +
                                std::to_string(options.height) +
                                " is out of range; use 16 to 16384 pixels each way");
  }
  const auto geometry = std::make_shared<const BallGeometry>(balls);
  MeshOptions mesh_options = options.mesh;
  mesh_options.translucent = options.style.complex_opacity < 1;
  const auto mesh =
      std::make_shared<const ComplexMesh>(build_mesh(*geometry, colours, complex, mesh_options));
  EglContext context;
  Scene scene;
  scene.set_style(options.style);
  scene.set_balls(geometry, colours);
  scene.set_ball_radii(drawn_radii(*geometry, options.balls));
  scene.set_mesh(mesh);
  write_png(scene.grab(options.width, options.height, options.transparent), path, options.texts);
}

}  // namespace alphascope
