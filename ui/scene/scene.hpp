// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D view: balls, tetrahedra, triangles, edges and boundary of an alpha complex. VTK draws it
// into a texture of the OpenGL context that is current when the Scene is made. No ImGui, no window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/molecule/rgb8.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/scene/camera.hpp"
#include "ui/scene/cut.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/pick/ball_pick.hpp"
#include "ui/scene/scene_data.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// An image with its top row first, 4 bytes (red, green, blue, alpha; not premultiplied) a pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

inline constexpr int kMostSamples = 16;  // of a pixel

// Settings of the picture that can change without a new mesh.
struct SceneStyle {
  bool balls = true;
  double ball_opacity = 1;     // above 0, at most 1
  double complex_opacity = 1;  // above 0, at most 1
  double cavity_opacity = 1;   // of translucent layers; above 0, at most 1
  double content_opacity = 1;  // of atoms in front; above 0, at most 1
  bool ambient_occlusion = true;
  float shadow_strength = 1;  // of ambient occlusion and shadows, 0 to 1
  float line_scale = 1;       // factor on the widths of lines; larger on a dense screen
  Theme theme = Theme::dark;
  std::optional<Rgb8> background = {};  // none: the theme's
  bool orthographic = false;            // no perspective
  Cut cut{};                 // applies to everything; balls are closed where they are cut
  float depth_cue = 0;       // share of the background colour at the greatest depth, 0 to 1
  float outlines = 0;        // width in pixels at line_scale 1; 0: none
  float face_lines = 0;      // darker lines around faces, pixels at line_scale 1; 0: none
  float rod_radius = 0.06f;  // of edges, Å
  int samples = 4;           // of each pixel of a fine picture, 1 to kMostSamples
  friend bool operator==(const SceneStyle&, const SceneStyle&) = default;
};

// sketch: a draft at half the resolution, where a draft takes too long.
// draft: for a moving picture.
// medium: with ambient occlusion and exact transparency.
// fine: adds one more sample of such quality. The picture is the mean of all samples since the last
// change, up to SceneStyle::samples.
enum class RenderQuality : std::uint8_t { sketch, draft, medium, fine };

enum class PointerButton : std::uint8_t { left, middle, right };

class Scene {
 public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // Whether any visible thing is translucent.
  bool draws_translucent() const;

  // Shows other balls. Removes the previous mesh and keeps the camera.
  void set_balls(std::shared_ptr<BallData> balls);
  void set_ball_radii(const std::vector<float>& radii);  // Å, as drawn
  void set_ball_colours(const std::vector<Rgb8>& colours);
  // Limit on the number of cells in each list of a mesh. OpenGL cannot index more
  // (beyond_opengl_text()).
  std::size_t most_cells() const;
  // Null removes the mesh. Each call removes the caps of the previous mesh.
  void set_mesh(std::shared_ptr<MeshData> mesh);
  // Milliseconds spent on handing faces and tetrahedra over to OpenGL since the last call. They are
  // part of the time of pictures.
  double take_upload_milliseconds();
  // Caps close the tetrahedra of the mesh in the planes of the cut; null: none. They are as opaque
  // as the tetrahedra.
  void set_caps(std::shared_ptr<CapData> caps);
  // Differences are drawn over everything else, so that nothing hides an error; null: none.
  void set_differences(std::shared_ptr<DifferenceData> differences);
  // Drawings that panels ask for; null: none. Labels are not among them: they are drawn over the
  // picture.
  void set_layers(std::shared_ptr<LayerData> layers);
  // Atoms that are not balls. They stay opaque when the rest fades; null: none.
  void set_beside_body(std::shared_ptr<LayerData> atoms);
  // Objects of the molecule's atoms in the place of those of this group, in any order. set_balls()
  // removes all.
  void set_objects(ObjectGroup group, std::vector<SceneObject> objects);
  // Selected balls, drawn in the style of all balls, even when those are hidden; null: none.
  // set_balls() removes them. `outlines`: only their rims are drawn, so that they hide little.
  void set_selected(std::shared_ptr<BallData> balls, bool outlines = false);
  // Shows balls at their own radii, and makes their BallData itself.
  void set_balls(std::shared_ptr<const BallGeometry> balls, const std::vector<Rgb8>& colours);
  void set_style(const SceneStyle& style);
  void reset_view();
  bool view_is_set() const;  // false: the next picture resets the view
  // Carries out a pending reset_view() now, for a picture of this size (pixels).
  void apply_pending_reset(int width, int height);
  Viewpoint viewpoint() const;
  // As viewpoint(). A narrower picture of it cuts off nothing that the last picture showed. Takes
  // time in proportion to the balls.
  Viewpoint viewpoint_of_pictures() const;
  void set_viewpoint(const Viewpoint& viewpoint);

  // Draws width x height pixels (at least 8 x 8) into the texture. Returns the milliseconds that
  // this took.
  double render(int width, int height, RenderQuality quality);
  // Like render(), but a GPU may still be drawing after the return (see take_milliseconds()).
  // Software OpenGL finishes the picture first, unless set_renders_asynchronously(true) was called:
  // it would take the cores from later work.
  void start_render(int width, int height, RenderQuality quality);
  bool renders_asynchronously()
      const;  // whether start_render() may return before the picture is drawn
  void set_renders_asynchronously(bool meanwhile);
  // Milliseconds that the picture of the last start_render() took; each time is returned once.
  // Empty if there is none, or if the picture is unfinished and `wait` is false.
  std::optional<double> take_milliseconds(bool wait);
  // Number of samples in the last picture, if it is fine and nothing has changed since; else 0.
  int samples_drawn() const;
  // OpenGL name of the texture of the last picture. Its first row is the bottom; its alpha reads as
  // 1.
  unsigned texture() const;
  // Width of a pixel at the camera's focal point (Å) in the last picture, rendered or grabbed.
  double angstrom_per_pixel() const;

  ViewFrustum sight() const;  // of the last picture
  // The line of sight through a pixel of the last picture; pixels count from its top left.
  Ray ray(double x, double y) const;

  // Trackball: the left button turns, the middle button or shift + left pans, the right button or
  // the wheel zooms. Coordinates are pixels of the picture from its top left.
  void pointer_move(int x, int y, bool control, bool shift);
  void pointer_button(PointerButton button, bool pressed);
  void wheel(double steps);  // positive: closer

  // A picture of any size in fine quality with the present camera. The next render() draws the
  // texture again. `transparent` leaves out the background. Progress is reported before each
  // sample. Throws Cancelled if cancelled between samples, and std::runtime_error if OpenGL cannot
  // draw this size.
  Image grab(int width, int height, bool transparent, const RunContext& context = {});

 private:
  struct Impl;
  Impl& changed();
  std::unique_ptr<Impl> impl_;
};

}  // namespace alphascope
