// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of Scene::Impl for the quality of a picture: transparency, occlusion, outlines, samples.
#include <vtkProperty.h>

#include <algorithm>

#include "core/document/picture/picture_options.hpp"
#include "ui/rgb8.hpp"
#include "ui/scene/gl/sample_place.hpp"
#include "ui/scene/scene_impl.hpp"

namespace alphascope {
namespace {

// Number of translucent layers that are drawn exactly. More layers take longer and make no visible
// difference.
constexpr int kPeels = 6;

// Occlusion rays ("taps") of a pixel on each scale: for all samples together, and limits for one
// sample.
constexpr int kOcclusionTaps = 160, kLeastTaps = 10, kMostTaps = 40;
constexpr float kNearOcclusion = 5.5f;  // Å: about two atoms
constexpr double kFarOcclusion = 0.07;  // of the diagonal of the box around all balls
constexpr float kShadowReach = 2;       // times the larger radius of occlusion
// An outline marks a jump in depth. The jump is at least this many widths of the outline, this
// share of the visible depth, and this many Å.
constexpr double kJumpPixels = 6, kJumpShare = 0.02, kLeastJump = 1.2;
constexpr Colour kLineOnLight{0.08f, 0.09f, 0.11f}, kLineOnDark{0, 0, 0};

}  // namespace

Colour background_of(const SceneStyle& style) {
  return style.background ? to_colour(*style.background) : palette(style.theme).scene;
}

void Scene::Impl::apply_quality(RenderQuality quality, bool transparent) {
  const bool exact = quality >= RenderQuality::medium;
  renderer->SetUseDepthPeeling(exact && anything_translucent());
  renderer->SetMaximumNumberOfPeels(kPeels);
  renderer->SetOcclusionRatio(0);
  samples = quality == RenderQuality::sketch ? kSketchSamples : 1;
  // Back faces of translucent cells take much of the drawing time.
  const bool front_only = !exact && faded(style.complex_opacity) < 1 && !style.cut.on();
  for (CellActor* c : {&boundary, &tetrahedra}) {
    c->actor->GetProperty()->SetBackfaceCulling(front_only);
    c->mapper->light_faces(!exact);
  }
  apply_finish(quality, transparent);
}

void Scene::Impl::apply_finish(RenderQuality quality, bool transparent) {
  finish = {};
  if (!balls) return;
  if (quality >= RenderQuality::medium && style.ambient_occlusion) {
    const int shared_by = quality == RenderQuality::fine ? style.samples : 1;
    finish.occlusion_taps = std::clamp(kOcclusionTaps / shared_by, kLeastTaps, kMostTaps);
  }
  finish.occlusion_strength = style.shadow_strength;
  finish.near_radius = kNearOcclusion;
  const auto& b = balls->bounds;
  const double size = diagonal({b[0], b[1], b[2], b[3], b[4], b[5]});
  finish.far_radius = static_cast<float>(std::max(2.0 * kNearOcclusion, kFarOcclusion * size));
  for (std::size_t k = 0; k < 3; ++k) finish.light[k] = static_cast<float>(kKeyLight[k]);
  finish.shadow_reach = kShadowReach * finish.far_radius;
  finish.depth_cue = style.depth_cue;
  finish.outline_width = style.outlines * style.line_scale * static_cast<float>(samples);
  finish.background = background_of(style);
  const bool light = style.background ? is_light(*style.background) : style.theme == Theme::light;
  finish.line = light ? kLineOnLight : kLineOnDark;
  finish.transparent = transparent;
  if (quality >= RenderQuality::medium && finish.any()) {
    finish.translucent_opacity = static_cast<float>(translucent_opacity());
  }
}

void Scene::Impl::add_sample(int width, int height) {
  if (!mean.is_of(width, height)) mean.forget();
  const auto [right, up] = sample_place(mean.count());
  finish.turn = mean.count();
  shift(right / width, up / height);
  draw(width, height);
  shift(0, 0);
  mean.add(window, width, height);
}

// The least jump grows with the visible size. Otherwise a large molecule seen whole would have an
// outline around each atom and show little else.
double Scene::Impl::outline_jump(double size) const {
  const double pixel = angstrom_per_pixel(), seen = std::min(size, 1.5 * pixel * picture_height);
  return std::max({kLeastJump, kJumpPixels * finish.outline_width * pixel, kJumpShare * seen});
}

Scene::Impl::ForOnePicture::ForOnePicture(Impl& scene, bool transparent) : scene_(scene) {
  scene.mean.forget();
  scene.apply_quality(RenderQuality::fine, transparent);
  if (transparent) {
    scene.renderer->SetBackground(0, 0, 0);
    scene.renderer->SetUseDepthPeeling(true);  // VTK's other transparency writes wrong alpha
  }
  scene.renderer->SetBackgroundAlpha(transparent ? 0 : 1);
}

Scene::Impl::ForOnePicture::~ForOnePicture() {
  scene_.mean.forget();
  scene_.shift(0, 0);
  scene_.renderer->SetBackgroundAlpha(0);
  scene_.apply_style();
}

}  // namespace alphascope
