// A scene in an EGL context, one frame, a file.
#include "ui/scene/screenshot.hpp"

#include <stdexcept>

#include "ui/scene/camera_place.hpp"
#include "ui/scene/draw_marks.hpp"
#include "ui/scene/drawing_memory.hpp"
#include "ui/scene/visible_mesh.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {

std::string render_screenshot(const BallSet& balls, const AlphaComplex& complex,
                              const std::vector<Rgb8>& colours, const ScreenshotOptions& options,
                              const std::filesystem::path& path, const RunContext& context) {
  const auto begin = [&context](const char* step, double share) {
    context.cancel.throw_if_cancelled();
    context.report(step, share);
  };
  constexpr int kLeast = 16, kMost = 16384;
  if (options.width < kLeast || options.width > kMost || options.height < kLeast ||
      options.height > kMost) {
    throw std::invalid_argument("screenshot size " + std::to_string(options.width) + "x" +
                                std::to_string(options.height) +
                                " is out of range; use 16 to 16384 pixels each way");
  }
  require_room(options.width, options.height, options.free_bytes);
  MeshOptions wanted = options.mesh;
  wanted.translucent = options.style.complex_opacity < 1;
  const std::uint64_t picture = picture_bytes(options.width, options.height);
  std::optional<std::uint64_t> free = options.free_bytes;
  if (free) *free -= picture;
  begin("preparing the picture", 0);
  const DrawingPlan plan = plan_drawing({balls.size(), &complex, nullptr, wanted}, free);
  const std::string not_drawn = not_drawn_text(plan);
  if (!plan.balls) throw std::runtime_error(not_drawn);
  PictureTexts texts = options.texts;
  if (!not_drawn.empty()) texts.emplace_back("Warning", not_drawn);
  begin("preparing the picture", 0.1);
  const auto geometry = std::make_shared<const BallGeometry>(balls);
  begin("preparing the picture", 0.2);
  const std::vector<bool>& hidden = options.looks.hidden;
  const std::vector<Rgb8> ball_colours = painted(colours, &options.looks);
  const std::vector<Rgb8> simplex_colours = options.simplex_colours.empty()
                                                ? ball_colours
                                                : painted(options.simplex_colours, &options.looks);
  const auto mesh = std::make_shared<const ComplexMesh>(
      build_visible_mesh(complex, hidden, [&](const AlphaComplex& part) {
        return build_mesh(*geometry, simplex_colours, part, plan.mesh, context.cancel);
      }));
  begin("drawing", 0.5);
  EglContext egl;
  Scene scene;
  SceneStyle style = options.style;
  if (options.clip) {
    style.cut = Cut(options.clip->resolved(geometry->axes[2], geometry->origin), geometry->origin);
  }
  scene.set_style(style);
  scene.set_balls(geometry, ball_colours);
  scene.set_ball_radii(shown_radii(drawn_radii(*geometry, options.balls), &options.looks));
  scene.set_mesh(make_mesh_data(mesh));
  if (style.cut.on()) {
    scene.set_caps(make_cap_data(std::make_shared<const CapMesh>(
        build_visible_caps(complex, hidden, [&](const AlphaComplex& part) {
          return build_cap_mesh(*geometry, simplex_colours, part, plan.mesh, mesh->scale, style.cut,
                                context.cancel);
        }))));
  }
  const auto layers =
      std::make_shared<const LayerMesh>(build_layer_mesh(*geometry, options.layers));
  scene.set_layers(make_layer_data(layers));
  if (options.beside_body) {
    scene.set_beside_body(make_layer_data(options.beside_body(*geometry)));
  }
  if (options.camera) scene.set_viewpoint(viewpoint_at(*options.camera, *geometry));
  begin("drawing", 0.7);
  std::optional<ColourLegend> legend = options.ball_legend;
  if (!legend && mesh->scale) legend = mesh->scale->legend();
  if (!options.legend) legend.reset();
  const std::string left_out =
      write_picture(scene,
                    {options.width, options.height, options.transparent, options.style.theme,
                     legend, options.scale_bar, layers->labels, style.cut},
                    path, texts, context);
  return not_drawn + (not_drawn.empty() || left_out.empty() ? "" : " ") + left_out;
}

}  // namespace alphascope
