// SPDX-License-Identifier: GPL-3.0-or-later
// The VTK objects behind a Scene, and the functions that apply its settings to them. Only the
// sources of Scene include this.
#pragma once

#include <vtkActor.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "ui/scene/gl/ball_mapper.hpp"
#include "ui/scene/gl/finish_pass.hpp"
#include "ui/scene/gl/mesh_actor.hpp"
#include "ui/scene/gl/picture_timer.hpp"
#include "ui/scene/gl/sample_mean.hpp"
#include "ui/scene/mesh/vtk_arrays.hpp"
#include "ui/scene/scene.hpp"
#include "ui/scene/scene_renderer.hpp"
#include "ui/scene/scene_window.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {

// Direction towards the light that casts shadows: right, up, towards the viewer.
constexpr double kKeyLight[3] = {-0.5, 0.7, 1.0};

constexpr double kSketchSamples = 0.5;  // samples of a sketch along each side of a pixel

inline double diagonal(const std::array<double, 6>& box) {
  return std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
}

// Faces and lines that are drawn over everything else.
struct MarkActors {
  MeshActor faces, edges;

  MarkActors();
  void add_to(vtkRenderer* renderer);
  void show(vtkPolyData* new_faces, vtkPolyData* new_edges, vtkWindow* window);
};

// Balls that each have a colour and a radius.
struct BallActor {
  vtkNew<BallMapper> mapper;
  vtkNew<vtkActor> actor;
  std::shared_ptr<BallData> data;

  BallActor();
  void show(std::shared_ptr<BallData> balls, vtkWindow* window);  // null: none
};

struct BodyActors {
  MeshActor faces, edges;  // edges of tetrahedra
  BallActor spheres;

  BodyActors();
  void add_to(vtkRenderer* renderer);
  void show(const BodyData& bodies, vtkWindow* window);
  void set_opacity(double opacity);
  bool visible() const { return faces.actor->GetVisibility() || spheres.actor->GetVisibility(); }
};

// Layers of panels: marks, drawn over everything, and bodies, drawn among the rest.
struct LayerActors {
  MarkActors marks;
  BodyActors opaque, translucent;
  MeshActor body_lines, tubes;
  BallActor atoms;                  // drawn in front of everything
  std::shared_ptr<LayerData> data;  // null: nothing

  LayerActors();
  void add_to(vtkRenderer* renderer);
  void show(std::shared_ptr<LayerData> layers, vtkWindow* window);
};

// An object: a cartoon's surface, sticks, spheres and points.
struct ObjectActors {
  MeshActor surface, dots;
  CellActor sticks;
  BallActor spheres;
  std::shared_ptr<BallPlaces> places = std::make_shared<BallPlaces>();  // of sticks
  std::shared_ptr<ObjectData> data;                                     // null: nothing
  float opacity = 1;
  const ObjectGroup group;

  explicit ObjectActors(ObjectGroup group);
  void add_to(vtkRenderer* renderer);
  void show(const SceneObject& object, vtkWindow* window);
  void set_opacity(double shown);
};

Colour background_of(const SceneStyle& style);

struct Scene::Impl {
  vtkNew<SceneWindow> window;
  vtkNew<SceneRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> trackball;
  BallActor all_balls, selected;
  std::shared_ptr<BallPlaces> places = std::make_shared<BallPlaces>();  // centres of all balls,
                                                                        // shared by the cells
  CellActor tetrahedra, boundary, triangles, edges;
  MeshActor caps, cap_edges;  // of tetrahedra; the cut does not apply to them
  std::shared_ptr<CapData> cap_data;
  MarkActors differences;
  std::shared_ptr<DifferenceData> difference_data;
  LayerActors layers, beside_body;
  std::vector<std::unique_ptr<ObjectActors>> objects;  // actors stay for later objects
  std::shared_ptr<const BallGeometry> balls;
  std::shared_ptr<MeshData> mesh;
  SceneStyle style;
  double least_aspect = 0, aspect = 0;        // least_aspect as in Viewpoint; aspect of the last
                                              // picture
  int picture_width = 1, picture_height = 1;  // pixels; a sketch has fewer samples
  double samples = 1;  // along each side of a pixel in the last picture; below 1 in a sketch
  FinishPass finish_pass;
  FinishSettings finish;  // of the next picture
  SampleMean mean;        // of fine pictures
  bool shows_mean = false;
  PictureTimer timer;
  std::optional<double> milliseconds;  // of a start_render() that waited for the picture
  bool renders_asynchronously = !draws_in_software();
  int pointer_x = 0, pointer_y = 0;  // pixels of the view
  bool reset_pending = false;        // resetting needs the size of the next picture

  Impl();
  std::array<CellActor*, 4> cells() { return {&tetrahedra, &boundary, &triangles, &edges}; }
  // Frees the buffers of soft shadows and exact transparency. They are as large as the largest
  // picture that used them. The next picture makes again the buffers that it needs.
  void release_buffers();
  // Opacity of the picture beside the bodies of layers: `opacity`, limited while a layer fades the
  // rest.
  double faded(double opacity) const;
  double opacity_of(const ObjectActors& object) const;
  bool anything_translucent() const;
  double translucent_opacity() const;  // largest opacity among translucent things; 0: there are
                                       // none
  void apply_style();
  void show_mesh(std::shared_ptr<MeshData> data);  // null: nothing
  void apply_quality(RenderQuality quality, bool transparent = false);
  void render(int width, int height, RenderQuality quality);
  void draw(int width, int height);
  void apply_pending_reset(int width, int height);  // see Scene::apply_pending_reset()
  unsigned texture();
  void add_sample(int width, int height);  // to the mean, after apply_quality()
  // Shifts the picture right and up, in shares of its width and height.
  void shift(double right, double up);
  void set_view_angle();
  // Without perspective VTK zooms by its parallel scale. This turns the change of scale into a
  // change of distance.
  void follow_zoom();
  ViewFrustum sight() const;
  double angstrom_per_pixel() const;       // at the focal point
  double outline_jump(double size) const;  // least jump in depth with an outline, Å; `size`:
                                           // diagonal of the drawing, Å

  // Settings for one picture that is saved; the destructor restores those of the view.
  class ForOnePicture {
   public:
    ForOnePicture(Impl& scene, bool transparent);
    ~ForOnePicture();
    ForOnePicture(const ForOnePicture&) = delete;
    ForOnePicture& operator=(const ForOnePicture&) = delete;

   private:
    Impl& scene_;
  };

 private:
  std::vector<vtkActor*> cut_meshes();
  std::vector<BallActor*> cut_balls();
  void apply_cut();
  void set_cut_plane_uniforms(int width, int height);
  void set_line_widths();
  // Moves the camera backwards. Without perspective it then stands behind everything, and moves
  // back after drawing.
  void step_back(double angstrom);
  void set_up_window();
  void set_up_lights();
  void follow_aspect(double now);
  // Bounding box (Å) of everything that is drawn; empty if nothing is drawn.
  std::optional<std::array<double, 6>> visible_box();
  void reset_camera();
  void apply_finish(RenderQuality quality, bool transparent);
};

}  // namespace alphascope
