// SPDX-License-Identifier: GPL-3.0-or-later
// Translates the display controls into options for scene, mesh and balls.
#include "ui/scene/display_style.hpp"

#include "ui/rgb8.hpp"

namespace alphascope {
namespace {

ComplexColouring colouring(ColourBy colour) {
  switch (colour) {
    case ColourBy::single:
      return ComplexColouring::single;
    case ColourBy::alpha:
      return ComplexColouring::alpha;
    case ColourBy::simplex_class:
      return ComplexColouring::classes;
    default:
      return ComplexColouring::balls;
  }
}

}  // namespace

SceneStyle scene_style(const DisplaySettings& display, Theme theme) {
  SceneStyle style;
  style.balls = display.balls;
  style.ball_opacity = display.ball_opacity;
  style.complex_opacity = display.complex_opacity;
  style.cavity_opacity = display.cavity_opacity;
  style.content_opacity = display.content_opacity;
  style.ambient_occlusion = display.ambient_occlusion;
  style.shadow_strength = display.shadow_strength;
  style.depth_cue = display.depth_cue;
  style.outlines = display.outlines;
  style.face_lines = display.face_lines;
  style.rod_radius = display.edge_thickness / 2;
  style.samples = display.samples;
  style.orthographic = display.orthographic;
  style.theme = theme;
  return style;
}

MeshOptions mesh_options(const DisplaySettings& display, Theme theme) {
  MeshOptions options;
  options.tetrahedra = display.tetrahedra;
  options.boundary = display.boundary;
  options.triangles = display.triangles;
  options.edges = display.edges;
  options.singular_only = display.singular_only;
  options.shrink = display.shrink;
  options.smooth_boundary = display.smooth_boundary;
  options.translucent = display.complex_opacity < 1;
  const Paint& paint = display.complex_paint;
  options.colouring = colouring(paint.by);
  options.single_colour = paint.colour.value_or(to_rgb8(palette(theme).complex_single));
  if (options.colouring == ComplexColouring::alpha) {
    options.alpha_colours = {paint.map_used(), paint.range};
  }
  return options;
}

std::optional<ColourMeaning> mesh_colour_meaning(const ComplexMesh& mesh,
                                                 const MeshOptions& options,
                                                 const std::optional<ColourMeaning>& of_balls) {
  if (mesh.empty()) return std::nullopt;
  switch (options.colouring) {
    case ComplexColouring::balls:
      return of_balls;
    case ComplexColouring::alpha:
      return mesh.scale ? std::optional(mesh.scale->key()) : std::nullopt;
    case ComplexColouring::classes:
      return class_colour_meaning();
    case ComplexColouring::single:
      break;
  }
  return std::nullopt;
}

BallStyle ball_style(const DisplaySettings& display, const Request* shown) {
  BallStyle style;
  style.scale = display.ball_scale;
  style.grown = display.grown_balls && shown != nullptr;
  if (!style.grown) return style;
  style.alpha = shown->alpha_angstrom2;
  style.solvent_radius = shown->solvent_radius_angstrom;
  return style;
}

}  // namespace alphascope
