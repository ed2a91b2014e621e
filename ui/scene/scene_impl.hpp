// The VTK objects behind a Scene, and how its settings become theirs. For the sources of Scene
// only.
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

// Where the light that casts shadows comes from: right, up, towards the viewer.
constexpr double kKeyLight[3] = {-0.5, 0.7, 1.0};

constexpr double kSketchSamples = 0.5;  // of a sketch

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

// Balls with colours and radii of their own.
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

// What panels want drawn: marks, and bodies among the rest.
struct LayerActors {
  MarkActors marks;
  BodyActors opaque, translucent;
  MeshActor body_lines, tubes;
  BallActor atoms;                  // before all else
  std::shared_ptr<LayerData> data;  // null: nothing

  LayerActors();
  void add_to(vtkRenderer* renderer);
  void show(std::shared_ptr<LayerData> layers, vtkWindow* window);
};

struct Scene::Impl {
  vtkNew<SceneWindow> window;
  vtkNew<SceneRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> trackball;
  BallActor all_balls, selected;
  std::shared_ptr<BallPlaces> places = std::make_shared<BallPlaces>();  // of balls
  CellActor tetrahedra, boundary, triangles, edges;
  MeshActor caps, cap_edges;  // of tetrahedra; not cut themselves
  std::shared_ptr<CapData> cap_data;
  MarkActors differences;
  std::shared_ptr<DifferenceData> difference_data;
  LayerActors layers, beside_body;
  std::shared_ptr<const BallGeometry> balls;
  std::shared_ptr<MeshData> mesh;
  SceneStyle style;
  double least_aspect = 0, aspect = 0;        // as in Viewpoint, and of the last picture
  int picture_width = 1, picture_height = 1;  // pixels, of which a sketch has fewer samples
  double samples = 1;  // each way, of the last picture; of a sketch less than one
  FinishPass finish_pass;
  Finish finish;    // of the next picture
  SampleMean mean;  // of fine pictures
  bool shows_mean = false;
  PictureTimer timer;
  std::optional<double> milliseconds;  // of a start_render() that waited
  bool draws_meanwhile = !draws_in_software();
  int pointer_x = 0, pointer_y = 0;  // pixels of the view
  bool reset_pending = false;        // the fit needs the size of the next picture

  Impl();
  std::array<CellActor*, 4> cells() { return {&tetrahedra, &boundary, &triangles, &edges}; }
  // Of what draws soft shadows and exact transparency, whose textures are as large as the last
  // picture that had them; the next picture makes again what it needs.
  void release_buffers();
  // What is not a body of a layer, beside one.
  double faded(double opacity) const;
  bool anything_translucent() const;
  double translucent_opacity() const;  // the largest of what is; 0: nothing is
  void apply_style();
  void show_mesh(std::shared_ptr<MeshData> data);  // null: nothing
  void apply_quality(RenderQuality quality, bool transparent = false);
  void render(int width, int height, RenderQuality quality);
  void draw(int width, int height);
  void settle_view(int width, int height);  // as Scene's
  unsigned texture();
  void add_sample(int width, int height);  // to the mean, after apply_quality()
  // To the right and up, in shares of the picture's width and height.
  void shift(double right, double up);
  void set_view_angle();
  // VTK zooms by another scale where there is no perspective; here by another distance, always.
  void follow_zoom();
  Sight sight() const;
  double angstrom_per_pixel() const;          // at the focal point
  double silhouette_jump(double size) const;  // Å; of what is drawn

  // What only a picture for a file has; ends with this.
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
  void give_cut_planes(int width, int height);
  void give_lines();
  // Behind everything, where no perspective tells where it stands; then back.
  void step_back(double angstrom);
  void set_up_window();
  void set_up_lights();
  void follow_aspect(double now);
  // Of all that is drawn. Nothing: there is nothing.
  std::optional<std::array<double, 6>> visible_box();
  void reset_camera();
  void apply_finish(RenderQuality quality, bool transparent);
};

}  // namespace alphascope
