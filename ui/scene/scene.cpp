// The scene's functions. vtkGenericOpenGLRenderWindow draws into framebuffers of its own in
// whatever context is current; nothing here knows where that comes from.
#include "ui/scene/scene.hpp"

#include <vtkCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ui/scene/frame_grab.hpp"
#include "ui/scene/scene_impl.hpp"
#include "ui/scene/vtk_arrays.hpp"

namespace alphascope {
namespace {

// VTK draws nothing, and says so nowhere, when one of its buffers cannot be had. The largest, in
// which samples add up, has four halves of floats a pixel; Mesa's software driver also limits the
// bytes.
bool drawable(int width, int height) {
  constexpr int kMost = 16384;
  if (std::max(width, height) > kMost) return false;
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA16F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  GLint possible = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &possible);
  return possible == width;
}
}  // namespace

Scene::Scene() : impl_(std::make_unique<Impl>()) {
  impl_->apply_style();
  reset_view();
}

Scene::~Scene() = default;

void Scene::set_balls(std::shared_ptr<BallData> balls) {
  impl_->mean.forget();
  set_mesh(nullptr);
  set_differences(nullptr);
  set_layers(nullptr);
  set_beside_body(nullptr);
  set_selected(nullptr);
  impl_->balls = balls->balls;
  impl_->places->set(balls->balls);
  impl_->all_balls.show(std::move(balls), impl_->window);
  impl_->apply_style();
}

void Scene::set_balls(std::shared_ptr<const BallGeometry> balls, const std::vector<Rgb8>& colours) {
  if (!balls) throw std::invalid_argument("there are no balls to draw");
  const std::vector<float> radii = drawn_radii(*balls, {});
  set_balls(make_ball_data(std::move(balls), colours, radii));
}

void Scene::set_ball_radii(const std::vector<float>& radii) {
  impl_->mean.forget();
  if (impl_->all_balls.data) set_radii(impl_->all_balls.data->points, radii);
}

void Scene::set_ball_colours(const std::vector<Rgb8>& colours) {
  impl_->mean.forget();
  if (impl_->all_balls.data) set_colours(impl_->all_balls.data->points, colours);
}

void Scene::set_mesh(std::shared_ptr<MeshData> mesh) {
  impl_->mean.forget();
  set_caps(nullptr);
  impl_->show_mesh(std::move(mesh));
}

double Scene::take_upload_milliseconds() {
  double sum = 0;
  for (CellActor* c : {&impl_->tetrahedra, &impl_->boundary, &impl_->triangles}) {
    sum += c->mapper->take_upload_milliseconds();
  }
  return sum;
}

void Scene::set_caps(std::shared_ptr<CapData> caps) {
  impl_->mean.forget();
  impl_->caps.show(caps ? caps->faces : nullptr, impl_->window);
  impl_->cap_edges.show(caps ? caps->edges : nullptr, impl_->window);
  impl_->cap_data = std::move(caps);  // only now may the old arrays go
  impl_->apply_style();
}

void Scene::set_differences(std::shared_ptr<DifferenceData> differences) {
  impl_->mean.forget();
  impl_->differences.show(differences ? differences->faces : nullptr,
                          differences ? differences->edges : nullptr, impl_->window);
  impl_->difference_data = std::move(differences);  // only now may the old arrays go
}

void Scene::set_layers(std::shared_ptr<LayerData> layers) {
  impl_->mean.forget();
  const bool had_peels = impl_->anything_translucent();
  impl_->layers.show(std::move(layers), impl_->window);
  if (had_peels && !impl_->anything_translucent()) impl_->release_buffers();
  impl_->apply_style();
}

void Scene::set_beside_body(std::shared_ptr<LayerData> atoms) {
  impl_->mean.forget();
  impl_->beside_body.show(std::move(atoms), impl_->window);
}

void Scene::set_selected(std::shared_ptr<BallData> balls) {
  impl_->mean.forget();
  impl_->selected.actor->SetVisibility(balls != nullptr);
  impl_->selected.show(std::move(balls), impl_->window);
}

void Scene::set_style(const SceneStyle& style) {
  impl_->mean.forget();
  const bool had_occlusion = impl_->style.ambient_occlusion;
  const bool had_peels = impl_->anything_translucent();
  impl_->style = style;
  if ((had_occlusion && !style.ambient_occlusion) ||
      (had_peels && !impl_->anything_translucent())) {
    impl_->release_buffers();
  }
  impl_->apply_style();
}

void Scene::reset_view() {
  impl_->mean.forget();
  impl_->reset_pending = true;
}

Viewpoint Scene::viewpoint() const {
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  Viewpoint v;
  camera->GetPosition(v.position.data());
  camera->GetFocalPoint(v.focal_point.data());
  camera->GetViewUp(v.up.data());
  v.least_aspect = impl_->least_aspect;
  return v;
}

void Scene::set_viewpoint(const Viewpoint& v) {
  impl_->mean.forget();
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  camera->SetPosition(v.position.data());
  camera->SetFocalPoint(v.focal_point.data());
  camera->SetViewUp(v.up.data());
  impl_->least_aspect = v.least_aspect;
  impl_->reset_pending = false;
  impl_->set_view_angle();
}

double Scene::render(int width, int height, RenderQuality quality) {
  const auto start = std::chrono::steady_clock::now();
  impl_->apply_quality(quality);
  impl_->picture_height = height;
  impl_->shows_mean = quality == RenderQuality::fine;
  if (impl_->shows_mean) {
    const bool done = impl_->mean.count() >= impl_->style.samples;
    if (!done || !impl_->mean.is_of(width, height)) impl_->add_sample(width, height);
    impl_->mean.resolve(impl_->window);
  } else {
    impl_->mean.forget();
    const auto samples_along = [&](int pixels) {
      return std::max(1, static_cast<int>(std::lround(pixels * impl_->samples)));
    };
    impl_->draw(samples_along(width), samples_along(height));
  }
  // VTK's texture does not filter, which what is smaller than the picture needs.
  glBindTexture(GL_TEXTURE_2D, texture());
  const GLint filter = impl_->samples != 1 ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  // VTK leaves arbitrary values in the alpha channel; whoever blends the picture must see one.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_ONE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glFinish();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

int Scene::samples_drawn() const {
  return impl_->mean.count();
}

unsigned Scene::texture() const {
  if (impl_->shows_mean) return impl_->mean.picture()->GetHandle();
  return impl_->window->GetDisplayFramebuffer()->GetColorAttachmentAsTextureObject(0)->GetHandle();
}

double Scene::angstrom_per_pixel() const {
  return impl_->angstrom_per_pixel();
}

Sight Scene::sight() const {
  return impl_->sight();
}

Ray Scene::ray(double x, double y) const {
  const int* size = impl_->window->GetSize();
  const double width = double(size[0]) / impl_->samples, height = double(size[1]) / impl_->samples;
  return ray_through(impl_->sight(), 2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height);
}

void Scene::pointer_move(int x, int y, bool control, bool shift) {
  impl_->mean.forget();
  const auto sample = [&](int pixel) {
    return static_cast<int>(std::lround(pixel * impl_->samples));
  };
  const int* size = impl_->window->GetSize();
  impl_->interactor->SetSize(size[0], size[1]);
  // VTK turns by the difference to the last position, which a picture of other samples had.
  impl_->interactor->SetEventInformationFlipY(sample(impl_->pointer_x), sample(impl_->pointer_y));
  impl_->interactor->SetEventInformationFlipY(sample(x), sample(y), control, shift);
  impl_->pointer_x = x;
  impl_->pointer_y = y;
  impl_->interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  impl_->follow_zoom();
}

void Scene::pointer_button(PointerButton button, bool pressed) {
  impl_->mean.forget();
  unsigned long event = vtkCommand::NoEvent;
  switch (button) {
    case PointerButton::left:
      event = pressed ? vtkCommand::LeftButtonPressEvent : vtkCommand::LeftButtonReleaseEvent;
      break;
    case PointerButton::middle:
      event = pressed ? vtkCommand::MiddleButtonPressEvent : vtkCommand::MiddleButtonReleaseEvent;
      break;
    case PointerButton::right:
      event = pressed ? vtkCommand::RightButtonPressEvent : vtkCommand::RightButtonReleaseEvent;
      break;
  }
  impl_->interactor->InvokeEvent(event);
}

void Scene::wheel(double steps) {
  impl_->mean.forget();
  const auto event =
      steps > 0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent;
  const int count = std::clamp(static_cast<int>(std::lround(std::fabs(steps))), 1, 10);
  for (int i = 0; i < count && steps != 0; ++i) impl_->interactor->InvokeEvent(event);
  impl_->follow_zoom();
}

// The samples that the window adds up at rest, too: the same pixels, at the same size.
Image Scene::grab(int width, int height, bool transparent, const RunContext& context) {
  if (!drawable(width, height)) {
    throw std::runtime_error("OpenGL on this machine cannot draw a picture of " +
                             std::to_string(width) + " x " + std::to_string(height) +
                             " pixels. Choose a smaller size.");
  }
  const Impl::ForOnePicture settings(*impl_, transparent);
  impl_->picture_height = height;
  for (int k = 0; k < impl_->style.samples; ++k) {
    context.cancel.throw_if_cancelled();
    context.report("drawing", double(k) / impl_->style.samples);
    impl_->add_sample(width, height);
  }
  const unsigned picture = impl_->mean.resolve(impl_->window)->GetFBOIndex();
  impl_->window->GetState()->ResetFramebufferBindings();
  Image image = read_framebuffer(picture, width, height);
  // Before anything else takes memory: these may be many times the view's.
  impl_->release_buffers();
  if (transparent) {
    divide_by_alpha(image);
  } else {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  }
  return image;
}

}  // namespace alphascope
