// SPDX-License-Identifier: GPL-3.0-or-later
// Scene::Impl: makes the VTK objects, applies settings to them, and moves the camera.
#include "ui/scene/scene_impl.hpp"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkObject.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "ui/scene/gl/cut_shader.hpp"
#include "ui/scene/mesh/vtk_arrays.hpp"

namespace alphascope {
namespace {

// Distance by which the orthographic camera steps back, in diagonals of the box around all that is
// drawn.
constexpr double kStepBack = 1.5;

}  // namespace

MarkActors::MarkActors() {
  faces.always_in_front();
  edges.always_in_front();
}

void MarkActors::add_to(vtkRenderer* renderer) {
  renderer->AddActor(faces.actor);
  renderer->AddActor(edges.actor);
}

void MarkActors::show(vtkPolyData* new_faces, vtkPolyData* new_edges, vtkWindow* window) {
  faces.show(new_faces, window);
  edges.show(new_edges, window);
}

BodyActors::BodyActors() {
  edges.before_its_faces();
  faces.brighter();
}

void BodyActors::add_to(vtkRenderer* renderer) {
  renderer->AddActor(faces.actor);
  renderer->AddActor(edges.actor);
  renderer->AddActor(spheres.actor);
}

void BodyActors::show(const BodyData& bodies, vtkWindow* window) {
  faces.show(bodies.faces, window);
  edges.show(bodies.edges, window);
  spheres.show(bodies.spheres, window);
}

void BodyActors::set_opacity(double opacity) {
  for (vtkActor* a : {faces.actor.Get(), edges.actor.Get(), spheres.actor.Get()}) {
    a->GetProperty()->SetOpacity(opacity);
  }
}

LayerActors::LayerActors() {
  body_lines.before_its_faces();
  tubes.brighter();
  tubes.smooth();
  atoms.mapper->set_look(BallRendering::in_front);
}

void LayerActors::add_to(vtkRenderer* renderer) {
  marks.add_to(renderer);
  opaque.add_to(renderer);
  translucent.add_to(renderer);
  for (MeshActor* m : {&body_lines, &tubes}) renderer->AddActor(m->actor);
  renderer->AddActor(atoms.actor);
}

void LayerActors::show(std::shared_ptr<LayerData> layers, vtkWindow* window) {
  const LayerData nothing;
  const LayerData& shown = layers ? *layers : nothing;
  marks.show(shown.faces, shown.edges, window);
  opaque.show(shown.opaque, window);
  translucent.show(shown.translucent, window);
  body_lines.show(shown.body_lines, window);
  tubes.show(shown.tubes, window);
  atoms.show(shown.atoms, window);
  data = std::move(layers);  // after show(), which replaces the old arrays
}

ObjectActors::ObjectActors(ObjectGroup of) : group(of) {
  surface.brighter();
  surface.smooth();
  dots.actor->GetProperty()->LightingOff();
  sticks.mapper->set_places(places);
}

void ObjectActors::add_to(vtkRenderer* renderer) {
  renderer->AddActor(surface.actor);
  renderer->AddActor(dots.actor);
  renderer->AddActor(sticks.actor);
  renderer->AddActor(spheres.actor);
}

void ObjectActors::show(const SceneObject& object, vtkWindow* window) {
  if (object.data != data) {
    const ObjectData nothing;
    const ObjectData& shown = object.data ? *object.data : nothing;
    surface.show(shown.surface, window);
    dots.show(shown.dots, window);
    spheres.show(shown.spheres, window);
    static const EdgeCells kNone;
    const bool any = shown.mesh && shown.mesh->sticks.places;
    places->buffer.release(window);
    if (any) places->set(shown.mesh->sticks.places);
    sticks.show(any ? shown.mesh->sticks.rods : kNone, window);
  }
  data = object.data;  // after the actors, which replace the old arrays
  opacity = object.opacity;
  sticks.mapper->bring_to_front(object.in_front);
}

void ObjectActors::set_opacity(double shown) {
  for (vtkActor* a :
       {surface.actor.Get(), dots.actor.Get(), sticks.actor.Get(), spheres.actor.Get()}) {
    a->GetProperty()->SetOpacity(shown);
  }
}

Scene::Impl::Impl() {
  set_up_window();
  set_up_lights();
  renderer->AddActor(all_balls.actor);
  renderer->AddActor(selected.actor);
  for (CellActor* c : cells()) {
    c->mapper->set_places(places);
    renderer->AddActor(c->actor);
  }
  for (MeshActor* m : {&caps, &cap_edges}) renderer->AddActor(m->actor);
  caps.unlit();
  cap_edges.actor->GetProperty()->LightingOff();
  caps.behind_balls(kBehindEdges);
  cap_edges.behind_balls(kBehindCapsOfBalls);
  layers.add_to(renderer);
  beside_body.add_to(renderer);
  differences.add_to(renderer);
  set_view_angle();
  renderer->after_opaque = [this] {
    if (finish.any()) finish_pass.apply(renderer, finish);
  };
  renderer->after_translucent = [this] {
    if (finish.translucent_opacity > 0) finish_pass.apply_to_translucent(renderer, finish);
  };
}

void Scene::Impl::release_buffers() {
  renderer->ReleaseGraphicsResources(window);
  finish_pass.release(window);
  mean.release(window);
  shows_mean = false;
}

void Scene::Impl::set_up_window() {
  // This also silences the complaint described in scene_window.hpp. VTK has no other switch for it.
  vtkObject::GlobalWarningDisplayOff();
  window->SetOwnContext(false);
  window->SetMapped(true);
  window->SetIsCurrent(true);
  window->SetSupportsOpenGL(1);
  window->SetIsDirect(1);
  window->SetReadyForRendering(true);
  window->SetFrameBlitModeToNoBlit();
  window->SetMultiSamples(0);  // VTK 9.1: samples lose translucent geometry when peeling
  window->SetSize(64, 64);
  window->AddRenderer(renderer);
  window->InitializeFromCurrentContext();
  window->SetAlphaBitPlanes(1);  // of the framebuffers; the context may have none of its own
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(trackball);
  interactor->EnableRenderOff();  // we decide when to draw
  interactor->Initialize();
  trackball->SetMouseWheelMotionFactor(0.7);
}

// All lights move with the camera. A key light is over the left shoulder, and a weak one below
// right. The third comes from behind and lights rims only.
void Scene::Impl::set_up_lights() {
  renderer->AutomaticLightCreationOff();
  const double lights[3][4] = {{kKeyLight[0], kKeyLight[1], kKeyLight[2], 0.85},
                               {0.8, -0.5, 0.8, 0.35},
                               {0.5, 0.8, -0.9, 0.3}};
  for (const auto& l : lights) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(l[0], l[1], l[2]);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(l[3]);
    renderer->AddLight(light);
  }
}

BallActor::BallActor() {
  mapper->SetColorModeToDirectScalars();
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  vtkProperty* property = actor->GetProperty();
  property->SetAmbient(0.18);
  property->SetDiffuse(0.82);
  property->SetSpecular(0.25);
  property->SetSpecularPower(40);
}

void BallActor::show(std::shared_ptr<BallData> balls, vtkWindow* window) {
  actor->SetVisibility(balls != nullptr);
  mapper->SetInputData(balls ? balls->points.Get() : nullptr);
  mapper->ReleaseGraphicsResources(window);
  data = std::move(balls);  // only now may the old arrays be freed
}

double Scene::Impl::faded(double opacity) const {
  const bool fades = layers.data && layers.data->mesh->fades_rest;
  return fades ? std::min(opacity, kFadedOpacity) : opacity;
}

double Scene::Impl::opacity_of(const ObjectActors& object) const {
  return object.group == ObjectGroup::layers ? object.opacity : faded(object.opacity);
}

double Scene::Impl::translucent_opacity() const {
  double opacity = 0;
  const double of_balls = style.balls ? faded(style.ball_opacity) : 1;
  const double of_cavities = layers.translucent.visible() ? style.cavity_opacity : 1;
  const double of_contents = layers.data && layers.data->atoms ? style.content_opacity : 1;
  for (const double o : {of_balls, faded(style.complex_opacity), of_cavities, of_contents}) {
    if (o < 1) opacity = std::max(opacity, o);
  }
  for (const auto& object : objects) {
    const double o = object->data ? opacity_of(*object) : 1;
    if (o < 1) opacity = std::max(opacity, o);
  }
  return opacity;
}

bool Scene::Impl::anything_translucent() const {
  return translucent_opacity() > 0;
}

void Scene::Impl::apply_style() {
  const Colour background = background_of(style);
  renderer->SetBackground(background.r, background.g, background.b);
  all_balls.actor->SetVisibility(style.balls && balls && !balls->centres.empty());
  all_balls.actor->GetProperty()->SetOpacity(faded(style.ball_opacity));
  for (CellActor* c : cells()) c->actor->GetProperty()->SetOpacity(faded(style.complex_opacity));
  layers.translucent.set_opacity(style.cavity_opacity);
  layers.atoms.actor->GetProperty()->SetOpacity(style.content_opacity);
  for (const auto& object : objects) object->set_opacity(opacity_of(*object));
  const bool closed = cap_data && style.cut.on();
  caps.actor->SetVisibility(closed && cap_data->faces);
  cap_edges.actor->SetVisibility(closed && cap_data->edges);
  caps.actor->GetProperty()->SetOpacity(faded(style.complex_opacity));
  cap_edges.actor->GetProperty()->SetOpacity(faded(style.complex_opacity));
  apply_cut();
}

void Scene::Impl::show_mesh(std::shared_ptr<MeshData> data) {
  const ComplexMesh nothing;
  const ComplexMesh& shown = data ? *data->mesh : nothing;
  tetrahedra.show(shown.outside, shown.tetrahedra, window);
  boundary.show(shown.boundary, {}, window);
  triangles.show(shown.triangles, {}, window);
  edges.show(shown.edges, window);
  mesh = std::move(data);  // after show(), which replaces the old arrays
}

std::vector<vtkActor*> Scene::Impl::cut_meshes() {
  std::vector<vtkActor*> all{differences.faces.actor, differences.edges.actor};
  for (CellActor* c : cells()) all.push_back(c->actor);
  for (LayerActors* l : {&layers, &beside_body}) {
    for (MeshActor* m : {&l->marks.faces, &l->marks.edges, &l->opaque.faces, &l->opaque.edges,
                         &l->translucent.faces, &l->translucent.edges, &l->body_lines, &l->tubes}) {
      all.push_back(m->actor);
    }
  }
  for (const auto& object : objects) all.push_back(object->dots.actor);
  return all;
}

std::vector<BallActor*> Scene::Impl::cut_balls() {
  std::vector<BallActor*> all{&all_balls,
                              &selected,
                              &layers.opaque.spheres,
                              &layers.translucent.spheres,
                              &layers.atoms,
                              &beside_body.opaque.spheres};
  for (const auto& object : objects) all.push_back(&object->spheres);
  return all;
}

void Scene::Impl::apply_cut() {
  for (vtkActor* a : cut_meshes()) cut_mesh_actor(a, style.cut.on());
  for (BallActor* b : cut_balls()) cut_ball_actor(b->actor, style.cut.on());
  for (const auto& object : objects) {
    cut_closed_actor(object->surface.actor, style.cut.on());
    cut_rod_actor(object->sticks.actor, style.cut.on());
  }
}

void Scene::Impl::set_cut_plane_uniforms(int width, int height) {
  if (!style.cut.on()) return;
  const CutPlanes planes(style.cut, renderer, width, height);
  for (vtkActor* a : cut_meshes()) planes.give_to(a);
  for (BallActor* b : cut_balls()) planes.give_to_rounded(b->actor);
  for (const auto& object : objects) {
    planes.give_to(object->surface.actor);
    planes.give_to_rounded(object->sticks.actor);
  }
}

// The radius of a rod is at least kLeastRod pixels, so that no rod is thinner than a line.
void Scene::Impl::set_line_widths() {
  constexpr double kLeastRod = 0.75;  // pixels, of its radius
  const double pixel =
      style.orthographic ? angstrom_per_pixel() : pixel_spread(sight(), picture_height);
  CellLines lines;
  lines.face_lines = style.face_lines * static_cast<float>(samples) * style.line_scale;
  lines.rod_radius = style.rod_radius;
  lines.rod_radius_per_depth = static_cast<float>(kLeastRod * style.line_scale * pixel);
  for (CellActor* c : cells()) c->mapper->set_lines(lines);
  for (const auto& object : objects) {
    if (object->data) lines.rod_radius = object->data->mesh->sticks.radius;
    object->sticks.mapper->set_lines(lines);
  }
}

void Scene::Impl::draw(int width, int height) {
  if (window->GetSize()[0] != width || window->GetSize()[1] != height) {
    window->SetSize(width, height);
  }
  apply_pending_reset(width, height);
  set_line_widths();
  const float width_scale = static_cast<float>(samples) * style.line_scale;
  differences.edges.actor->GetProperty()->SetLineWidth(3.5f * width_scale);
  layers.marks.edges.actor->GetProperty()->SetLineWidth(2.5f * width_scale);
  layers.body_lines.actor->GetProperty()->SetLineWidth(2.5f * width_scale);
  for (BodyActors* b : {&layers.opaque, &layers.translucent}) {
    b->edges.actor->GetProperty()->SetLineWidth(1.2f * width_scale);
  }
  cap_edges.actor->GetProperty()->SetLineWidth(1.0f * width_scale);
  for (const auto& object : objects) {
    object->dots.actor->GetProperty()->SetPointSize(3.0f * width_scale);
  }
  const auto box = visible_box();
  finish.outline_jump = static_cast<float>(outline_jump(box ? diagonal(*box) : 0));
  const double back = style.orthographic && box ? kStepBack * diagonal(*box) : 0;
  step_back(back);
  if (box) renderer->ResetCameraClippingRange(box->data());
  set_cut_plane_uniforms(width, height);
  window->Render();
  step_back(-back);
}

double Scene::Impl::angstrom_per_pixel() const {
  return 2 * renderer->GetActiveCamera()->GetDistance() * sight().tangent_up / picture_height;
}

std::optional<std::array<double, 6>> Scene::Impl::visible_box() {
  std::array<double, 6> box;
  renderer->ComputeVisiblePropBounds(box.data());
  if (box[0] > box[1]) return std::nullopt;
  return box;
}

// Keeps everything that a wide picture showed in sight when the picture becomes narrow.
void Scene::Impl::follow_aspect(double now) {
  const bool shown_at_usual_angle = least_aspect <= aspect;
  if (now < aspect && shown_at_usual_angle && balls && !reset_pending) {
    least_aspect = alphascope::least_aspect(*balls, sight(), aspect);
  }
  // This width cuts nothing off, so earlier narrower widths are forgotten. The view, also as saved,
  // then does not depend on sizes that the picture had in between.
  if (least_aspect <= now) least_aspect = 0;
  aspect = now;
  set_view_angle();
}

void Scene::Impl::shift(double right, double up) {
  renderer->GetActiveCamera()->SetWindowCenter(2 * right, 2 * up);
}

void Scene::Impl::follow_zoom() {
  vtkCamera* camera = renderer->GetActiveCamera();
  if (!style.orthographic) return;
  const double seen = camera->GetDistance() * tangent_up(aspect, least_aspect);
  const double wanted = camera->GetParallelScale();
  if (seen > 0 && std::fabs(wanted / seen - 1) > 1e-9) {
    step_back(camera->GetDistance() * (wanted / seen - 1));
  }
}

void Scene::Impl::step_back(double angstrom) {
  if (angstrom == 0) return;
  vtkCamera* camera = renderer->GetActiveCamera();
  double position[3];
  camera->GetPosition(position);
  const double* forward = camera->GetDirectionOfProjection();
  const double towards[3] = {forward[0], forward[1], forward[2]};
  for (int k = 0; k < 3; ++k) position[k] -= angstrom * towards[k];
  camera->SetPosition(position);
}

void Scene::Impl::set_view_angle() {
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(style.orthographic);
  camera->SetParallelScale(camera->GetDistance() * tangent_up(aspect, least_aspect));
  const double half = std::atan(tangent_up(aspect, least_aspect));
  renderer->GetActiveCamera()->SetViewAngle(2 * half * 180 / M_PI);
}

void Scene::Impl::apply_pending_reset(int width, int height) {
  follow_aspect(static_cast<double>(width) / height);
  if (balls && std::exchange(reset_pending, false)) reset_camera();
}

void Scene::Impl::reset_camera() {
  if (!balls) return;
  vtkCamera* camera = renderer->GetActiveCamera();
  const auto& towards = balls->axes[2];
  const auto& up = balls->axes[1];
  camera->SetFocalPoint(0, 0, 0);
  std::span<const float> drawn;
  if (style.balls && all_balls.data) drawn = radii_of(*all_balls.data);
  const double distance = fitting_distance(*balls, drawn, aspect);
  camera->SetPosition(distance * towards[0], distance * towards[1], distance * towards[2]);
  camera->SetViewUp(up[0], up[1], up[2]);
  least_aspect = 0;
  set_view_angle();
}

ViewFrustum Scene::Impl::sight() const {
  vtkCamera* camera = renderer->GetActiveCamera();
  ViewFrustum s;
  camera->GetPosition(s.position.data());
  camera->GetDirectionOfProjection(s.forward.data());
  camera->GetViewUp(s.up.data());
  vtkMath::Cross(s.forward.data(), s.up.data(), s.right.data());
  vtkMath::Normalize(s.right.data());
  // VTK's view-up vector need not be at a right angle to the direction.
  vtkMath::Cross(s.right.data(), s.forward.data(), s.up.data());
  s.tangent_up = tangent_up(aspect, least_aspect);
  s.tangent_right = s.tangent_up * aspect;
  s.distance = camera->GetDistance();
  s.orthographic = style.orthographic;
  return s;
}

}  // namespace alphascope
