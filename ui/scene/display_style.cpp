// See the header.
#include "ui/scene/display_style.hpp"

#include "ui/scene/ball_colours.hpp"

namespace alphascope {
namespace {

ComplexColouring colouring(ColourBy colour) {
  switch (colour) {
    case ColourBy::single:
      return ComplexColouring::single;
    case ColourBy::alpha:
      return ComplexColouring::alpha;
    case ColourBy::element:
    case ColourBy::chain:
    case ColourBy::exposed:
    case ColourBy::exposed_residue:
      break;
  }
  return ComplexColouring::balls;
}

}  // namespace

SceneStyle scene_style(const DisplayControls& display, Theme theme) {
  SceneStyle style;
  style.balls = display.balls;
  style.ball_opacity = display.ball_opacity;
  style.complex_opacity = display.complex_opacity;
  style.ambient_occlusion = display.ambient_occlusion;
  style.depth_cue = display.depth_cue;
  style.silhouettes = display.silhouettes;
  style.samples = display.samples;
  style.orthographic = display.orthographic;
  style.theme = theme;
  return style;
}

MeshOptions mesh_options(const DisplayControls& display, Theme theme) {
  MeshOptions options;
  options.tetrahedra = display.tetrahedra;
  options.boundary = display.boundary;
  options.triangles = display.triangles;
  options.edges = display.edges;
  options.singular_only = display.singular_only;
  options.shrink = display.shrink;
  options.translucent = display.complex_opacity < 1;
  options.colouring = colouring(display.complex_colour);
  options.single_colour = to_rgb8(palette(theme).complex_single);
  return options;
}

BallStyle ball_style(const DisplayControls& display, const Request* shown) {
  BallStyle style;
  style.scale = display.ball_scale;
  style.grown = display.grown_balls && shown != nullptr;
  if (!style.grown) return style;
  style.alpha = shown->alpha_angstrom2;
  style.solvent_radius = shown->solvent_radius_angstrom;
  return style;
}

}  // namespace alphascope
