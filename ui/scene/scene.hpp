// The 3-D view: balls, tetrahedra, triangles, edges and boundary of an alpha complex, drawn by VTK
// into a texture of the OpenGL context that is current when it is made. No ImGui, no window.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

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

// What is shown and how; everything that costs no new mesh.
struct SceneStyle {
  bool balls = true;
  double ball_opacity = 1;     // above 0, at most 1
  double complex_opacity = 1;  // above 0, at most 1
  double cavity_opacity = 1;   // of layers that are translucent; above 0, at most 1
  bool ambient_occlusion = true;
  float line_scale = 1;  // of the width of lines: the controls' on a dense screen
  Theme theme = Theme::dark;
  bool orthographic = false;  // no perspective
  Cut cut{};                  // of everything; balls are closed where they are cut
  float depth_cue = 0;        // share of the background in what is farthest, 0 to 1
  float silhouettes = 0;      // width in pixels at line_scale 1; 0: none
  float side_width = 0;       // of darker lines around faces, pixels at line_scale 1; 0: none
  float rod_radius = 0.06f;   // of edges, Å
  int samples = 4;            // a pixel of a fine picture, 1 to kMostSamples
  friend bool operator==(const SceneStyle&, const SceneStyle&) = default;
};

// sketch: a draft of half the resolution, where a draft takes too long. draft: while something
// moves. medium: with ambient occlusion and exact transparency. fine: one more such sample, the
// picture being the mean of all since anything changed, up to SceneStyle::samples.
enum class RenderQuality : std::uint8_t { sketch, draft, medium, fine };

enum class PointerButton : std::uint8_t { left, middle, right };

class Scene {
 public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // Whether anything on show lets something behind it through.
  bool draws_translucent() const;

  // Other balls; removes the mesh of the last ones and keeps the camera.
  void set_balls(std::shared_ptr<BallData> balls);
  void set_ball_radii(const std::vector<float>& radii);  // Å, as drawn
  void set_ball_colours(const std::vector<Rgb8>& colours);
  // Of the lists of a mesh: beyond, OpenGL here cannot index them (beyond_opengl_text()).
  std::size_t most_cells() const;
  // Null: none. Removes the caps of the last one.
  void set_mesh(std::shared_ptr<MeshData> mesh);
  // Of the time of pictures, what went into handing faces and tetrahedra over to OpenGL, since this
  // was last asked.
  double take_upload_milliseconds();
  // What closes the tetrahedra of the mesh in the planes of the cut; null: nothing. Not shown with
  // translucent ones.
  void set_caps(std::shared_ptr<CapData> caps);
  // Drawn over everything else, so that nothing hides what is wrong; null: none.
  void set_differences(std::shared_ptr<DifferenceData> differences);
  // What panels want drawn; null: nothing. Labels are not drawn here, but over the picture.
  void set_layers(std::shared_ptr<LayerData> layers);
  // Atoms that are no balls, drawn whatever else fades; null: none.
  void set_beside_body(std::shared_ptr<LayerData> atoms);
  // Balls that are drawn as the first ones are, whether or not these are; null: none. They go with
  // the first ones. `outlines`: only their rims, so that they hide little.
  void set_selected(std::shared_ptr<BallData> balls, bool outlines = false);
  // As the first, with balls' own radii and data that are made on the way.
  void set_balls(std::shared_ptr<const BallGeometry> balls, const std::vector<Rgb8>& colours);
  void set_style(const SceneStyle& style);
  void reset_view();
  bool view_is_set() const;  // and not to be reset with the next picture
  // A view that is to be reset is so now, for a picture of this size.
  void settle_view(int width, int height);
  Viewpoint viewpoint() const;
  void set_viewpoint(const Viewpoint& viewpoint);

  // Draws into the texture, width x height pixels (at least 8 x 8); returns milliseconds taken.
  double render(int width, int height, RenderQuality quality);
  // As render(), but a GPU may go on drawing after this returns: see take_milliseconds(). OpenGL in
  // software has then drawn it, unless told otherwise: it would take the cores from what follows.
  void start_render(int width, int height, RenderQuality quality);
  bool draws_meanwhile() const;  // start_render()
  void set_draws_meanwhile(bool meanwhile);
  // How long the picture of the last start_render() took, once. Nothing when there is none, or,
  // unless told to wait, when it is not finished.
  std::optional<double> take_milliseconds(bool wait);
  // Samples in the last picture where that is fine, and nothing has changed since; else 0.
  int samples_drawn() const;
  // OpenGL name of the last picture; its first row is the bottom, its alpha reads as one.
  unsigned texture() const;
  // Å that one pixel of the last picture, rendered or grabbed, spans at the camera's focal point.
  double angstrom_per_pixel() const;

  Sight sight() const;  // of the last picture
  // The line of sight through a pixel of the last picture, counted from its top left.
  Ray ray(double x, double y) const;

  // Trackball: left turns, middle or shift + left shifts, right or wheel zooms. Coordinates in
  // pixels of the picture from its top left.
  void pointer_move(int x, int y, bool control, bool shift);
  void pointer_button(PointerButton button, bool pressed);
  void wheel(double steps);  // positive: closer

  // A picture of any size in fine quality with the present camera; the texture is redrawn by the
  // next render(). `transparent` leaves the background out. Tells its share and can be cancelled
  // after each sample; then throws Cancelled.
  Image grab(int width, int height, bool transparent, const RunContext& context = {});

 private:
  struct Impl;
  Impl& changed();
  std::unique_ptr<Impl> impl_;
};

}  // namespace alphascope
