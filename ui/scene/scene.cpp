// SPDX-License-Identifier: GPL-3.0-or-later
// The public functions of Scene. VTK draws into framebuffers of its own in the current OpenGL
// context. This file does not know where that context comes from.
#include "ui/scene/scene.hpp"

#include <vtkCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/scene/mesh/vtk_arrays.hpp"
#include "ui/scene/picture/frame_grab.hpp"
#include "ui/scene/picture/step_text.hpp"
#include "ui/scene/scene_impl.hpp"

namespace alphascope {
namespace {

// Whether OpenGL can provide all buffers for a picture of this size. If one is missing, VTK draws
// nothing and reports no error. The largest buffer, in which samples add up, has four 16-bit floats
// a pixel. Mesa's software driver also limits its bytes.
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

// Every function that changes the picture calls this, so samples from before the change do not
// enter the next mean.
Scene::Impl& Scene::changed() {
  impl_->mean.forget();
  return *impl_;
}

void Scene::set_balls(std::shared_ptr<BallData> balls) {
  Impl& scene = changed();
  set_mesh(nullptr);
  set_differences(nullptr);
  set_layers(nullptr);
  set_beside_body(nullptr);
  set_objects(ObjectGroup::settings, {});
  set_objects(ObjectGroup::layers, {});
  set_selected(nullptr);
  scene.balls = balls->balls;
  scene.places->set(balls->balls);
  scene.all_balls.show(std::move(balls), scene.window);
  scene.apply_style();
}

void Scene::set_balls(std::shared_ptr<const BallGeometry> balls, const std::vector<Rgb8>& colours) {
  if (!balls) throw std::invalid_argument("there are no balls to draw");
  const std::vector<float> radii = drawn_radii(*balls, {});
  set_balls(make_ball_data(std::move(balls), colours, radii));
}

void Scene::set_ball_radii(const std::vector<float>& radii) {
  Impl& scene = changed();
  if (scene.all_balls.data) set_radii(scene.all_balls.data->points, radii);
}

void Scene::set_ball_colours(const std::vector<Rgb8>& colours) {
  Impl& scene = changed();
  if (scene.all_balls.data) set_colours(scene.all_balls.data->points, colours);
}

std::size_t Scene::most_cells() const {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return most > 0 ? static_cast<std::size_t>(most) : 0;
}

void Scene::set_mesh(std::shared_ptr<MeshData> mesh) {
  Impl& scene = changed();
  set_caps(nullptr);
  scene.show_mesh(std::move(mesh));
}

double Scene::take_upload_milliseconds() {
  double sum = 0;
  for (CellActor* c : impl_->cells()) {
    sum += c->mapper->take_upload_milliseconds();
  }
  return sum;
}

void Scene::set_caps(std::shared_ptr<CapData> caps) {
  Impl& scene = changed();
  scene.caps.show(caps ? caps->faces : nullptr, scene.window);
  scene.cap_edges.show(caps ? caps->edges : nullptr, scene.window);
  scene.cap_data = std::move(caps);  // after show(), which replaces the old arrays
  scene.apply_style();
}

void Scene::set_differences(std::shared_ptr<DifferenceData> differences) {
  Impl& scene = changed();
  scene.differences.show(differences ? differences->faces : nullptr,
                         differences ? differences->edges : nullptr, scene.window);
  scene.difference_data = std::move(differences);  // after show(), which replaces the old arrays
}

void Scene::set_layers(std::shared_ptr<LayerData> layers) {
  Impl& scene = changed();
  const bool had_peels = scene.anything_translucent();
  scene.layers.show(std::move(layers), scene.window);
  if (had_peels && !scene.anything_translucent()) scene.release_buffers();
  scene.apply_style();
}

void Scene::set_beside_body(std::shared_ptr<LayerData> atoms) {
  Impl& scene = changed();
  scene.beside_body.show(std::move(atoms), scene.window);
}

void Scene::set_objects(ObjectGroup group, std::vector<SceneObject> objects) {
  Impl& scene = changed();
  const bool had_peels = scene.anything_translucent();
  std::size_t shown = 0;
  for (const auto& actors : scene.objects) {
    if (actors->group != group) continue;
    actors->show(shown < objects.size() ? objects[shown] : SceneObject{}, scene.window);
    ++shown;
  }
  for (; shown < objects.size(); ++shown) {
    scene.objects.push_back(std::make_unique<ObjectActors>(group));
    scene.objects.back()->add_to(scene.renderer);
    scene.objects.back()->show(objects[shown], scene.window);
  }
  if (had_peels && !scene.anything_translucent()) scene.release_buffers();
  scene.apply_style();
}

void Scene::set_selected(std::shared_ptr<BallData> balls, bool outlines) {
  Impl& scene = changed();
  scene.selected.mapper->set_look(outlines ? BallRendering::outline : BallRendering::usual);
  scene.selected.show(std::move(balls), scene.window);
}

void Scene::set_style(const SceneStyle& style) {
  Impl& scene = changed();
  const bool had_occlusion = scene.style.ambient_occlusion;
  const bool had_peels = scene.anything_translucent();
  scene.style = style;
  if ((had_occlusion && !style.ambient_occlusion) || (had_peels && !scene.anything_translucent())) {
    scene.release_buffers();
  }
  scene.apply_style();
}

bool Scene::draws_translucent() const {
  return impl_->anything_translucent();
}

void Scene::reset_view() {
  Impl& scene = changed();
  scene.reset_pending = true;
}

bool Scene::view_is_set() const {
  return !impl_->reset_pending;
}

void Scene::apply_pending_reset(int width, int height) {
  changed().apply_pending_reset(width, height);
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

Viewpoint Scene::viewpoint_of_pictures() const {
  Viewpoint v = viewpoint();
  const Impl& scene = *impl_;
  if (scene.balls && scene.aspect > 0 && v.least_aspect <= scene.aspect) {
    v.least_aspect = least_aspect(*scene.balls, scene.sight(), scene.aspect);
  }
  return v;
}

void Scene::set_viewpoint(const Viewpoint& v) {
  Impl& scene = changed();
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(v.position.data());
  camera->SetFocalPoint(v.focal_point.data());
  camera->SetViewUp(v.up.data());
  scene.least_aspect = v.least_aspect;
  scene.reset_pending = false;
  scene.set_view_angle();
}

double Scene::render(int width, int height, RenderQuality quality) {
  const auto start = std::chrono::steady_clock::now();
  impl_->render(width, height, quality);
  glFinish();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

void Scene::start_render(int width, int height, RenderQuality quality) {
  if (!impl_->renders_asynchronously || !impl_->timer.start()) {
    impl_->milliseconds = render(width, height, quality);
    return;
  }
  impl_->milliseconds.reset();
  impl_->render(width, height, quality);
  impl_->timer.stop();
  glFlush();
}

bool Scene::renders_asynchronously() const {
  return impl_->renders_asynchronously;
}

void Scene::set_renders_asynchronously(bool meanwhile) {
  impl_->renders_asynchronously = meanwhile;
}

std::optional<double> Scene::take_milliseconds(bool wait) {
  if (auto taken = std::exchange(impl_->milliseconds, {})) return taken;
  return impl_->timer.take_milliseconds(wait);
}

// Hands all drawing over to OpenGL, which may still be drawing after the return.
void Scene::Impl::render(int width, int height, RenderQuality quality) {
  apply_quality(quality);
  picture_width = width;
  picture_height = height;
  shows_mean = quality == RenderQuality::fine;
  if (shows_mean) {
    const bool done = mean.count() >= style.samples;
    if (!done || !mean.is_of(width, height)) add_sample(width, height);
    mean.resolve(window);
  } else {
    mean.forget();
    const auto samples_along = [&](int pixels) {
      return std::max(1, static_cast<int>(std::lround(pixels * samples)));
    };
    draw(samples_along(width), samples_along(height));
  }
  // VTK's texture does not filter. A picture of fewer pixels than the view needs a filter.
  glBindTexture(GL_TEXTURE_2D, texture());
  const GLint filter = samples != 1 ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  // VTK leaves arbitrary values in the alpha channel, so alpha is made to read as 1 for blending.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_ONE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

int Scene::samples_drawn() const {
  return impl_->mean.count();
}

unsigned Scene::texture() const {
  return impl_->texture();
}

unsigned Scene::Impl::texture() {
  if (shows_mean) return mean.picture()->GetHandle();
  return window->GetDisplayFramebuffer()->GetColorAttachmentAsTextureObject(0)->GetHandle();
}

double Scene::angstrom_per_pixel() const {
  return impl_->angstrom_per_pixel();
}

ViewFrustum Scene::sight() const {
  return impl_->sight();
}

Ray Scene::ray(double x, double y) const {
  const double width = impl_->picture_width, height = impl_->picture_height;
  return ray_through(impl_->sight(), 2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height);
}

void Scene::pointer_move(int x, int y, bool control, bool shift) {
  Impl& scene = changed();
  const auto sample = [&](int pixel) {
    return static_cast<int>(std::lround(pixel * scene.samples));
  };
  const int* size = scene.window->GetSize();
  scene.interactor->SetSize(size[0], size[1]);
  // VTK turns by the difference to the last position. That position may be from a picture of
  // another resolution, so it is given anew.
  scene.interactor->SetEventInformationFlipY(sample(scene.pointer_x), sample(scene.pointer_y));
  scene.interactor->SetEventInformationFlipY(sample(x), sample(y), control, shift);
  scene.pointer_x = x;
  scene.pointer_y = y;
  scene.interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  scene.follow_zoom();
}

void Scene::pointer_button(PointerButton button, bool pressed) {
  Impl& scene = changed();
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
  scene.interactor->InvokeEvent(event);
}

void Scene::wheel(double steps) {
  Impl& scene = changed();
  const auto event =
      steps > 0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent;
  const int count = std::clamp(static_cast<int>(std::lround(std::fabs(steps))), 1, 10);
  for (int i = 0; i < count && steps != 0; ++i) scene.interactor->InvokeEvent(event);
  scene.follow_zoom();
}

// Adds up the same samples as the window at rest. So a picture of the same size has the same
// pixels.
Image Scene::grab(int width, int height, bool transparent, const RunContext& context) {
  if (!drawable(width, height)) {
    throw std::runtime_error("OpenGL on this machine cannot draw a picture of " +
                             std::to_string(width) + " x " + std::to_string(height) +
                             " pixels. Choose a smaller size.");
  }
  const Impl::ForOnePicture settings(*impl_, transparent);
  impl_->picture_width = width;
  impl_->picture_height = height;
  const int samples = impl_->style.samples;
  const auto begun = std::chrono::steady_clock::now();
  for (int k = 0; k < samples; ++k) {
    context.cancel.throw_if_cancelled();
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begun;
    context.report(samples == 1 ? "drawing" : step_text("sample", k, samples, since.count()),
                   double(k) / samples);
    impl_->add_sample(width, height);
  }
  const unsigned picture = impl_->mean.resolve(impl_->window)->GetFBOIndex();
  impl_->window->GetState()->ResetFramebufferBindings();
  Image image = read_framebuffer(picture, width, height);
  // These buffers may be many times larger than the view's; later steps may need the memory.
  impl_->release_buffers();
  if (transparent) {
    divide_by_alpha(image);
  } else {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  }
  return image;
}

}  // namespace alphascope
