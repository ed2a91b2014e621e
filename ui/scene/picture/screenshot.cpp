// Makes a Picture of a complex, and draws it in an EGL context into a file.
#include "ui/scene/picture/screenshot.hpp"

#include <stdexcept>
#include <utility>

#include "core/complex/own_dimension.hpp"
#include "ui/scene/camera_place.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"
#include "ui/scene/mesh/visible_mesh.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

void begin(const RunContext& context, const char* step, double share) {
  context.cancel.throw_if_cancelled();
  context.report(step, share);
}

constexpr const char* kPreparing = "preparing the picture";

void require_size(const ScreenshotOptions& options) {
  constexpr int kLeast = 16, kMost = 16384;
  if (options.width < kLeast || options.width > kMost || options.height < kLeast ||
      options.height > kMost) {
    throw std::invalid_argument("screenshot size " + std::to_string(options.width) + "x" +
                                std::to_string(options.height) +
                                " is out of range; use 16 to 16384 pixels each way");
  }
  require_room(options.width, options.height, options.free_bytes);
}

}  // namespace

Picture PictureMaker::make(const AlphaComplex& complex, const std::vector<Rgb8>& colours,
                           const ScreenshotOptions& options, const RunContext& context) {
  require_size(options);
  MeshOptions wanted = options.mesh;
  wanted.translucent = options.style.complex_opacity < 1;
  std::optional<std::uint64_t> free = options.free_bytes;
  if (free) *free -= picture_bytes(options.width, options.height);
  begin(context, kPreparing, 0);
  const DrawingPlan plan = plan_drawing({balls_.size(), &complex, nullptr, wanted}, free);
  Picture picture;
  picture.not_drawn = not_drawn_text(plan);
  if (!plan.balls) throw std::runtime_error(picture.not_drawn);
  picture.texts = options.texts;
  if (!picture.not_drawn.empty()) picture.texts.emplace_back("Warning", picture.not_drawn);
  begin(context, kPreparing, 0.1);
  if (!geometry_) geometry_ = std::make_shared<const BallGeometry>(balls_);
  if (!beside_body_ && options.beside_body) beside_body_ = options.beside_body(*geometry_);
  begin(context, kPreparing, 0.2);
  const std::vector<bool>& hidden = options.looks.hidden;
  picture.balls = geometry_;
  picture.colours = painted(colours, &options.looks);
  picture.radii = shown_radii(drawn_radii(*geometry_, options.balls), &options.looks);
  const std::vector<Rgb8> simplex_colours = options.simplex_colours.empty()
                                                ? picture.colours
                                                : painted(options.simplex_colours, &options.looks);
  const auto mesh = std::make_shared<const ComplexMesh>(build_visible_mesh(
      InOwnDimension(balls_, complex).complex(), hidden, [&](const AlphaComplex& part) {
        return build_mesh(*geometry_, simplex_colours, part, plan.mesh, context.cancel);
      }));
  picture.mesh = mesh;
  picture.style = options.style;
  if (options.clip) {
    picture.style.cut =
        Cut(options.clip->resolved(geometry_->axes[2], geometry_->origin), geometry_->origin);
  }
  const Cut& cut = picture.style.cut;
  if (cut.on()) {
    picture.caps = std::make_shared<const CapMesh>(
        build_visible_caps(complex, hidden, [&](const AlphaComplex& part) {
          return build_cap_mesh(*geometry_, simplex_colours, part, plan.mesh, mesh->scale, cut,
                                context.cancel);
        }));
  }
  picture.layers = options.layers;
  picture.beside_body = beside_body_;
  if (options.camera) picture.viewpoint = viewpoint_at(*options.camera, *geometry_);
  std::vector<ColourLegend> legends;
  if (options.legend) {
    legends = legends_of(options.style.balls ? options.ball_key : std::nullopt,
                         mesh_key(*mesh, plan.mesh, options.simplex_key));
  }
  picture.picture = {options.width,
                     options.height,
                     options.transparent,
                     options.style.theme,
                     std::move(legends),
                     options.scale_bar,
                     {},
                     cut,
                     options.caption};
  return picture;
}

std::string render_picture(const Picture& picture, const std::filesystem::path& path,
                           const RunContext& context) {
  begin(context, "drawing", 0.5);
  EglContext egl;
  Scene scene;
  const MarkedPicture marked = show(scene, picture);
  begin(context, "drawing", 0.7);
  const std::string left_out = write_picture(scene, marked, path, picture.texts, context);
  const bool both = !picture.not_drawn.empty() && !left_out.empty();
  return picture.not_drawn + (both ? " " : "") + left_out;
}

std::string render_screenshot(const BallSet& balls, const AlphaComplex& complex,
                              const std::vector<Rgb8>& colours, const ScreenshotOptions& options,
                              const std::filesystem::path& path, const RunContext& context) {
  return render_picture(PictureMaker(balls).make(complex, colours, options, context), path,
                        context);
}

}  // namespace alphascope
