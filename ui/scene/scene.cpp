// VTK objects behind the scene. vtkGenericOpenGLRenderWindow draws into framebuffers of its own in
// whatever context is current; nothing here knows where that comes from.
#include "ui/scene/scene.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLState.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
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
#include "ui/scene/vtk_arrays.hpp"

namespace alphascope {
namespace {

constexpr double kViewAngleDegrees = 25;  // less than VTK's 30: molecules distort less
// Exact transparency of this many layers; more cost time and show no difference.
constexpr int kPeels = 6;
constexpr int kFineSamples = 2;  // each way
// Units of depth by which differences are moved to the front: more than any molecule is deep.
constexpr double kToTheFront = -1e6;

struct MeshActor {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  MeshActor() {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointData();
    actor->SetMapper(mapper);
    actor->VisibilityOff();
    vtkProperty* property = actor->GetProperty();
    property->SetInterpolationToFlat();
    property->SetAmbient(0.18);
    property->SetDiffuse(0.82);
    property->SetSpecular(0.12);
    property->SetSpecularPower(20);
  }
  void show(const CellSoup& soup, int corners, vtkWindow* window) {
    if (soup.points() == 0) {
      hide(window);
      return;
    }
    mapper->SetInputData(soup_to_vtk(soup, corners));
    actor->VisibilityOn();
  }
  void hide(vtkWindow* window) {
    mapper->SetInputData(nullptr);
    mapper->ReleaseGraphicsResources(window);  // else its buffers stay until it draws again
    actor->VisibilityOff();
  }
  void always_in_front() {
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, kToTheFront);
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, kToTheFront);
    actor->GetProperty()->LightingOff();
  }
};

}  // namespace

struct Scene::Impl {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> trackball;
  vtkNew<vtkOpenGLSphereMapper> ball_mapper;
  vtkNew<vtkActor> ball_actor;
  vtkSmartPointer<vtkPolyData> ball_data;
  MeshActor tetrahedra, boundary, triangles, edges, differing_faces, differing_edges;
  std::shared_ptr<const BallGeometry> balls;
  std::shared_ptr<const ComplexMesh> mesh;  // VTK reads its arrays in place
  std::shared_ptr<const DifferenceMesh> differences;
  SceneStyle style;
  int picture_height = 1;
  int samples = 1;             // each way, of the last picture
  bool reset_pending = false;  // the fit needs the size of the next picture

  Impl() {
    set_up_window();
    set_up_lights();
    ball_mapper->SetScaleArray(kRadiusArray);
    ball_mapper->SetColorModeToDirectScalars();
    ball_actor->SetMapper(ball_mapper);
    ball_actor->VisibilityOff();
    ball_actor->GetProperty()->SetAmbient(0.18);
    ball_actor->GetProperty()->SetDiffuse(0.82);
    ball_actor->GetProperty()->SetSpecular(0.25);
    ball_actor->GetProperty()->SetSpecularPower(40);
    edges.actor->GetProperty()->LightingOff();
    renderer->AddActor(ball_actor);
    for (MeshActor* m : {&tetrahedra, &boundary, &triangles, &edges}) renderer->AddActor(m->actor);
    for (MeshActor* m : {&differing_faces, &differing_edges}) {
      m->always_in_front();
      renderer->AddActor(m->actor);
    }
    renderer->GetActiveCamera()->SetViewAngle(kViewAngleDegrees);
  }

  void set_up_window() {
    // Debian's VTK carries the GLX build of GLEW, which complains about an EGL context although
    // every function is found; there is no other way to hush it.
    vtkObject::GlobalWarningDisplayOff();
    window->SetOwnContext(false);
    window->SetMapped(true);
    window->SetIsCurrent(true);
    window->SetSupportsOpenGL(1);
    window->SetIsDirect(1);
    window->SetReadyForRendering(true);
    window->SetFrameBlitModeToNoBlit();
    window->SetMultiSamples(0);  // VTK 9.1: samples lose translucent geometry when peeling
    window->SetAlphaBitPlanes(1);
    window->SetSize(64, 64);
    window->AddRenderer(renderer);
    window->InitializeFromCurrentContext();
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(trackball);
    interactor->EnableRenderOff();  // we decide when to draw
    interactor->Initialize();
    trackball->SetMouseWheelMotionFactor(0.7);
  }

  // A key light over the left shoulder and a weak one from below right, both with the camera.
  void set_up_lights() {
    renderer->AutomaticLightCreationOff();
    const double lights[2][4] = {{-0.5, 0.7, 1.0, 0.85}, {0.8, -0.5, 0.8, 0.35}};
    for (const auto& l : lights) {
      vtkNew<vtkLight> light;
      light->SetLightTypeToCameraLight();
      light->SetPosition(l[0], l[1], l[2]);
      light->SetFocalPoint(0, 0, 0);
      light->SetIntensity(l[3]);
      renderer->AddLight(light);
    }
  }

  // Of what draws soft shadows and exact transparency, whose textures are as large as the last
  // picture that had them; the next picture makes again what it needs.
  void release_buffers() { renderer->ReleaseGraphicsResources(window); }

  bool anything_translucent() const {
    return (style.balls && style.ball_opacity < 1) || style.complex_opacity < 1;
  }

  void apply_style() {
    const Colour& background = palette(style.theme).scene;
    renderer->SetBackground(background.r, background.g, background.b);
    ball_actor->SetVisibility(style.balls && balls && !balls->centres.empty());
    ball_actor->GetProperty()->SetOpacity(style.ball_opacity);
    for (MeshActor* m : {&tetrahedra, &boundary, &triangles, &edges}) {
      m->actor->GetProperty()->SetOpacity(style.complex_opacity);
    }
  }

  void apply_quality(RenderQuality quality, bool occlusion_allowed = true) {
    const bool fine = quality != RenderQuality::draft;
    renderer->SetUseDepthPeeling(fine && anything_translucent());
    renderer->SetMaximumNumberOfPeels(kPeels);
    renderer->SetOcclusionRatio(0);
    const bool occlusion = fine && style.ambient_occlusion && occlusion_allowed && balls;
    renderer->SetUseSSAO(occlusion);
    if (occlusion) {
      renderer->SetSSAORadius(6);  // Å: about two atoms
      renderer->SetSSAOBias(0.2);
      renderer->SetSSAOKernelSize(64);
      renderer->SetSSAOBlur(true);
    }
    samples = quality == RenderQuality::fine ? kFineSamples : 1;
  }

  void draw(int width, int height) {
    if (window->GetSize()[0] != width || window->GetSize()[1] != height) {
      window->SetSize(width, height);
    }
    if (balls && std::exchange(reset_pending, false)) reset_camera();
    const float width_scale = static_cast<float>(samples);
    edges.actor->GetProperty()->SetLineWidth(1.5f * width_scale);
    differing_edges.actor->GetProperty()->SetLineWidth(3.5f * width_scale);
    renderer->ResetCameraClippingRange();
    window->Render();
  }

  void reset_camera() {
    if (!balls) return;
    vtkCamera* camera = renderer->GetActiveCamera();
    const auto& towards = balls->axes[2];
    const auto& up = balls->axes[1];
    camera->SetFocalPoint(0, 0, 0);
    const double distance = fitting_distance();
    camera->SetPosition(distance * towards[0], distance * towards[1], distance * towards[2]);
    camera->SetViewUp(up[0], up[1], up[2]);
  }

  // From here the outline of the balls just fits into the picture with a small margin.
  double fitting_distance() const {
    const double half = kViewAngleDegrees * M_PI / 360;
    const int* size = window->GetSize();
    const double aspect = size[1] > 0 ? double(size[0]) / size[1] : 1.6;
    const double tangent_up = std::tan(half), tangent_right = tangent_up * aspect;
    double distance = 1;
    for (std::size_t i = 0; i < balls->centres.size(); ++i) {
      double along[3];
      for (int a = 0; a < 3; ++a) {
        along[a] = 0;
        for (int k = 0; k < 3; ++k) along[a] += balls->axes[a][k] * balls->centres[i][k];
      }
      const double reach = std::max((std::fabs(along[0]) + balls->radii[i]) / tangent_right,
                                    (std::fabs(along[1]) + balls->radii[i]) / tangent_up);
      distance = std::max(distance, reach + along[2]);
    }
    return 1.08 * distance;
  }
};

Scene::Scene() : impl_(std::make_unique<Impl>()) {
  impl_->apply_style();
  reset_view();
}

Scene::~Scene() = default;

void Scene::set_balls(std::shared_ptr<const BallGeometry> balls, const std::vector<Rgb8>& colours) {
  if (!balls || balls->centres.size() != colours.size()) {
    throw std::invalid_argument("every ball needs one colour");
  }
  set_mesh(nullptr);
  set_differences(nullptr);
  impl_->balls = std::move(balls);
  impl_->ball_data = balls_to_vtk(*impl_->balls);
  set_radii(impl_->ball_data, drawn_radii(*impl_->balls, {}));
  set_colours(impl_->ball_data, colours);
  impl_->ball_mapper->SetInputData(impl_->ball_data);
  impl_->ball_mapper->ReleaseGraphicsResources(impl_->window);
  impl_->apply_style();
}

void Scene::set_ball_radii(const std::vector<float>& radii) {
  if (impl_->ball_data) set_radii(impl_->ball_data, radii);
}

void Scene::set_ball_colours(const std::vector<Rgb8>& colours) {
  if (impl_->ball_data) set_colours(impl_->ball_data, colours);
}

void Scene::set_mesh(std::shared_ptr<const ComplexMesh> mesh) {
  if (mesh) {
    impl_->tetrahedra.show(mesh->tetrahedra, 3, impl_->window);
    impl_->boundary.show(mesh->boundary, 3, impl_->window);
    impl_->triangles.show(mesh->triangles, 3, impl_->window);
    impl_->edges.show(mesh->edges, 2, impl_->window);
  } else {
    for (MeshActor* m : {&impl_->tetrahedra, &impl_->boundary, &impl_->triangles, &impl_->edges}) {
      m->hide(impl_->window);
    }
  }
  impl_->mesh = std::move(mesh);  // only now may the old arrays go
}

void Scene::set_differences(std::shared_ptr<const DifferenceMesh> differences) {
  if (differences) {
    impl_->differing_faces.show(differences->faces, 3, impl_->window);
    impl_->differing_edges.show(differences->edges, 2, impl_->window);
  } else {
    impl_->differing_faces.hide(impl_->window);
    impl_->differing_edges.hide(impl_->window);
  }
  impl_->differences = std::move(differences);
}

void Scene::set_style(const SceneStyle& style) {
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
  impl_->reset_pending = true;
}

double Scene::render(int width, int height, RenderQuality quality) {
  const auto start = std::chrono::steady_clock::now();
  impl_->apply_quality(quality);
  impl_->picture_height = height;
  impl_->draw(width * impl_->samples, height * impl_->samples);
  // VTK's texture does not filter; averaging the samples is what they are for.
  glBindTexture(GL_TEXTURE_2D, texture());
  const GLint filter = impl_->samples > 1 ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  // VTK leaves arbitrary values in the alpha channel; whoever blends the picture must see one.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_ONE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glFinish();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

unsigned Scene::texture() const {
  return impl_->window->GetDisplayFramebuffer()->GetColorAttachmentAsTextureObject(0)->GetHandle();
}

double Scene::angstrom_per_pixel() const {
  const vtkCamera* camera = impl_->renderer->GetActiveCamera();
  const double distance = const_cast<vtkCamera*>(camera)->GetDistance();
  return 2 * distance * std::tan(kViewAngleDegrees * M_PI / 360) / impl_->picture_height;
}

Ray Scene::ray(double x, double y) const {
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  const int* size = impl_->window->GetSize();
  const double width = double(size[0]) / impl_->samples, height = double(size[1]) / impl_->samples;
  const double tangent = std::tan(kViewAngleDegrees * M_PI / 360);
  Ray ray;
  double forward[3], up[3], right[3];
  camera->GetPosition(ray.start.data());
  camera->GetDirectionOfProjection(forward);
  camera->GetViewUp(up);
  vtkMath::Cross(forward, up, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);  // the camera's own need not be at a right angle
  const double across = (2 * (x + 0.5) / width - 1) * tangent * width / height;
  const double upwards = (1 - 2 * (y + 0.5) / height) * tangent;
  for (int k = 0; k < 3; ++k) {
    ray.direction[k] = forward[k] + across * right[k] + upwards * up[k];
  }
  return ray;
}

void Scene::pointer_move(int x, int y, bool control, bool shift) {
  const int s = impl_->samples;
  const int* size = impl_->window->GetSize();
  impl_->interactor->SetSize(size[0], size[1]);
  impl_->interactor->SetEventInformationFlipY(x * s, y * s, control, shift);
  impl_->interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
}

void Scene::pointer_button(PointerButton button, bool pressed) {
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
  const auto event =
      steps > 0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent;
  const int count = std::clamp(static_cast<int>(std::lround(std::fabs(steps))), 1, 10);
  for (int i = 0; i < count && steps != 0; ++i) impl_->interactor->InvokeEvent(event);
}

Image Scene::grab(int width, int height, bool transparent) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const bool oversample = kFineSamples * std::max(width, height) <= std::min(largest, 16384);
  // Ambient occlusion darkens towards the background, which a transparent picture has none of.
  impl_->apply_quality(oversample ? RenderQuality::fine : RenderQuality::medium, !transparent);
  vtkRenderer* renderer = impl_->renderer;
  if (transparent) {
    renderer->SetBackground(0, 0, 0);
    renderer->SetUseDepthPeeling(true);  // VTK's other transparency writes wrong alpha
  }
  renderer->SetBackgroundAlpha(transparent ? 0 : 1);
  impl_->picture_height = height;
  impl_->draw(width * impl_->samples, height * impl_->samples);
  // Before anything else takes memory: these may be many times the view's.
  impl_->release_buffers();
  renderer->SetBackgroundAlpha(0);
  impl_->apply_style();
  impl_->window->GetState()->ResetFramebufferBindings();
  Image image = read_framebuffer(impl_->window->GetDisplayFramebuffer()->GetFBOIndex(),
                                 width * impl_->samples, height * impl_->samples);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    std::uint8_t* p = &image.rgba[i];
    if (!transparent) p[3] = 255;
    if (p[3] == 0 || p[3] == 255) continue;
    for (int c = 0; c < 3; ++c) {  // VTK's colours are premultiplied
      p[c] = static_cast<std::uint8_t>(std::min(255, p[c] * 255 / p[3]));
    }
  }
  return downsample(image, impl_->samples);
}

}  // namespace alphascope
