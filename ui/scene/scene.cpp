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
#include "ui/scene/mesh_actor.hpp"
#include "ui/scene/vtk_arrays.hpp"

namespace alphascope {
namespace {

// Exact transparency of this many layers; more cost time and show no difference.
constexpr int kPeels = 6;
constexpr int kFineSamples = 2;  // each way

// Of sample `k` of kFineSamples in a row: pixels from the middle of its pixel.
double sample_place(int k) {
  return (k + 0.5) / kFineSamples - 0.5;
}

// VTK draws nothing, and says so nowhere, when one of its buffers cannot be had. The largest, which
// ambient occlusion takes, has four floats a pixel; Mesa's software driver also limits the bytes.
bool drawable(int width, int height) {
  constexpr int kMost = 16384;
  if (std::max(width, height) > kMost) return false;
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  GLint possible = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &possible);
  return possible == width;
}
}  // namespace

// Faces and lines that are drawn over everything else.
struct MarkActors {
  MeshActor faces, edges;
  std::shared_ptr<DifferenceData> data;

  MarkActors() {
    faces.always_in_front();
    edges.always_in_front();
  }
  void show(std::shared_ptr<DifferenceData> marks, vtkWindow* window) {
    faces.show(marks ? marks->faces : nullptr, window);
    edges.show(marks ? marks->edges : nullptr, window);
    data = std::move(marks);  // only now may the old arrays go
  }
};

struct Scene::Impl {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> trackball;
  vtkNew<vtkOpenGLSphereMapper> ball_mapper;
  vtkNew<vtkActor> ball_actor;
  MeshActor tetrahedra, boundary, triangles, edges;
  MarkActors layers, differences;
  std::shared_ptr<BallData> ball_data;
  std::shared_ptr<const BallGeometry> balls;
  std::shared_ptr<MeshData> mesh;
  SceneStyle style;
  double least_aspect = 0, aspect = 0;  // as in Viewpoint, and of the last picture
  int picture_height = 1;
  int samples = 1;                   // each way, of the last picture
  int pointer_x = 0, pointer_y = 0;  // pixels of the view
  bool reset_pending = false;        // the fit needs the size of the next picture

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
    for (MarkActors* marks : {&layers, &differences}) {
      renderer->AddActor(marks->faces.actor);
      renderer->AddActor(marks->edges.actor);
    }
    set_view_angle();
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
    follow_aspect(static_cast<double>(width) / height);
    if (balls && std::exchange(reset_pending, false)) reset_camera();
    const float width_scale = static_cast<float>(samples);
    edges.actor->GetProperty()->SetLineWidth(1.5f * width_scale);
    differences.edges.actor->GetProperty()->SetLineWidth(3.5f * width_scale);
    layers.edges.actor->GetProperty()->SetLineWidth(2.5f * width_scale);
    renderer->ResetCameraClippingRange();
    window->Render();
  }

  // What a wide picture shows stays in sight when it becomes narrow.
  void follow_aspect(double now) {
    const bool shown_at_usual_angle = least_aspect <= aspect;
    if (now < aspect && shown_at_usual_angle && balls && !reset_pending) {
      least_aspect = alphascope::least_aspect(*balls, sight(), aspect);
    }
    aspect = now;
    set_view_angle();
  }

  // To the right and up, in shares of the picture's width and height.
  void shift(double right, double up) {
    renderer->GetActiveCamera()->SetWindowCenter(2 * right, 2 * up);
  }

  // What only a picture for a file has; ends with this.
  class ForOnePicture {
   public:
    ForOnePicture(Impl& scene, bool transparent) : scene_(scene) {
      // Ambient occlusion darkens towards the background, which a transparent picture has none of.
      scene.apply_quality(RenderQuality::medium, !transparent);
      if (transparent) {
        scene.renderer->SetBackground(0, 0, 0);
        scene.renderer->SetUseDepthPeeling(true);  // VTK's other transparency writes wrong alpha
      }
      scene.renderer->SetBackgroundAlpha(transparent ? 0 : 1);
    }
    ~ForOnePicture() {
      scene_.shift(0, 0);
      scene_.renderer->SetBackgroundAlpha(0);
      scene_.apply_style();
    }
    ForOnePicture(const ForOnePicture&) = delete;
    ForOnePicture& operator=(const ForOnePicture&) = delete;

   private:
    Impl& scene_;
  };

  void set_view_angle() {
    const double half = std::atan(tangent_up(aspect, least_aspect));
    renderer->GetActiveCamera()->SetViewAngle(2 * half * 180 / M_PI);
  }

  void reset_camera() {
    if (!balls) return;
    vtkCamera* camera = renderer->GetActiveCamera();
    const auto& towards = balls->axes[2];
    const auto& up = balls->axes[1];
    camera->SetFocalPoint(0, 0, 0);
    const double distance = fitting_distance(*balls, aspect);
    camera->SetPosition(distance * towards[0], distance * towards[1], distance * towards[2]);
    camera->SetViewUp(up[0], up[1], up[2]);
    least_aspect = 0;
    set_view_angle();
  }

  Sight sight() const {
    vtkCamera* camera = renderer->GetActiveCamera();
    Sight s;
    camera->GetPosition(s.position.data());
    camera->GetDirectionOfProjection(s.forward.data());
    camera->GetViewUp(s.up.data());
    vtkMath::Cross(s.forward.data(), s.up.data(), s.right.data());
    vtkMath::Normalize(s.right.data());
    // The camera's own need not be at a right angle.
    vtkMath::Cross(s.right.data(), s.forward.data(), s.up.data());
    s.tangent_up = tangent_up(aspect, least_aspect);
    s.tangent_right = s.tangent_up * aspect;
    return s;
  }
};

Scene::Scene() : impl_(std::make_unique<Impl>()) {
  impl_->apply_style();
  reset_view();
}

Scene::~Scene() = default;

void Scene::set_balls(std::shared_ptr<BallData> balls) {
  set_mesh(nullptr);
  set_differences(nullptr);
  set_layers(nullptr);
  impl_->balls = balls->balls;
  impl_->ball_mapper->SetInputData(balls->points);
  impl_->ball_mapper->ReleaseGraphicsResources(impl_->window);
  impl_->ball_data = std::move(balls);
  impl_->apply_style();
}

void Scene::set_balls(std::shared_ptr<const BallGeometry> balls, const std::vector<Rgb8>& colours) {
  if (!balls) throw std::invalid_argument("there are no balls to draw");
  const std::vector<float> radii = drawn_radii(*balls, {});
  set_balls(make_ball_data(std::move(balls), colours, radii));
}

void Scene::set_ball_radii(const std::vector<float>& radii) {
  if (impl_->ball_data) set_radii(impl_->ball_data->points, radii);
}

void Scene::set_ball_colours(const std::vector<Rgb8>& colours) {
  if (impl_->ball_data) set_colours(impl_->ball_data->points, colours);
}

void Scene::set_mesh(std::shared_ptr<MeshData> mesh) {
  const MeshData nothing;
  const MeshData& shown = mesh ? *mesh : nothing;
  impl_->tetrahedra.show(shown.tetrahedra, impl_->window);
  impl_->boundary.show(shown.boundary, impl_->window);
  impl_->triangles.show(shown.triangles, impl_->window);
  impl_->edges.show(shown.edges, impl_->window);
  impl_->mesh = std::move(mesh);  // only now may the old arrays go
}

void Scene::set_differences(std::shared_ptr<DifferenceData> differences) {
  impl_->differences.show(std::move(differences), impl_->window);
}

void Scene::set_layers(std::shared_ptr<DifferenceData> layers) {
  impl_->layers.show(std::move(layers), impl_->window);
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
  const double distance = impl_->renderer->GetActiveCamera()->GetDistance();
  return 2 * distance * impl_->sight().tangent_up / impl_->picture_height;
}

Sight Scene::sight() const {
  return impl_->sight();
}

Ray Scene::ray(double x, double y) const {
  const int* size = impl_->window->GetSize();
  const double width = double(size[0]) / impl_->samples, height = double(size[1]) / impl_->samples;
  const Sight sight = impl_->sight();
  const double across = (2 * (x + 0.5) / width - 1) * sight.tangent_right;
  const double upwards = (1 - 2 * (y + 0.5) / height) * sight.tangent_up;
  Ray ray;
  ray.start = sight.position;
  for (int k = 0; k < 3; ++k) {
    ray.direction[k] = sight.forward[k] + across * sight.right[k] + upwards * sight.up[k];
  }
  return ray;
}

void Scene::pointer_move(int x, int y, bool control, bool shift) {
  const int s = impl_->samples;
  const int* size = impl_->window->GetSize();
  impl_->interactor->SetSize(size[0], size[1]);
  // VTK turns by the difference to the last position, which a picture of other samples had.
  impl_->interactor->SetEventInformationFlipY(impl_->pointer_x * s, impl_->pointer_y * s);
  impl_->interactor->SetEventInformationFlipY(x * s, y * s, control, shift);
  impl_->pointer_x = x;
  impl_->pointer_y = y;
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

// Four pictures, each a quarter of a pixel off, instead of one of four times the pixels: the same
// points are looked at, with a quarter of the memory, and between two of them it can be cancelled.
Image Scene::grab(int width, int height, bool transparent, const RunContext& context) {
  if (!drawable(width, height)) {
    throw std::runtime_error("OpenGL on this machine cannot draw a picture of " +
                             std::to_string(width) + " x " + std::to_string(height) +
                             " pixels. Choose a smaller size.");
  }
  const Impl::ForOnePicture settings(*impl_, transparent);
  impl_->picture_height = height;
  PictureMean mean;
  for (int k = 0; k < kFineSamples * kFineSamples; ++k) {
    context.cancel.throw_if_cancelled();
    context.report("drawing", double(k) / (kFineSamples * kFineSamples));
    impl_->shift(sample_place(k % kFineSamples) / width, sample_place(k / kFineSamples) / height);
    impl_->draw(width, height);
    impl_->window->GetState()->ResetFramebufferBindings();
    Image image =
        read_framebuffer(impl_->window->GetDisplayFramebuffer()->GetFBOIndex(), width, height);
    for (std::size_t i = 3; !transparent && i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    mean.add(image);
  }
  // Before anything else takes memory: these may be many times the view's.
  impl_->release_buffers();
  return mean.mean();
}

}  // namespace alphascope
