// SPDX-License-Identifier: GPL-3.0-or-later
// Draws marks as balls a little larger than those that they mark.
#include "app/viewer/scene/selection_marks.hpp"

#include <algorithm>
#include <memory>

#include "core/document/reference/ref_set.hpp"
#include "core/radii/amber_radii.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {
namespace {

// The radius of a mark is kMarkScale times the ball's plus kMarkRim (Å), so that it covers the
// ball.
constexpr float kMarkScale = 1.06f, kMarkRim = 0.05f;
// Least radius of marks, for balls that are not drawn because alpha is too low or balls are off.
constexpr float kLeastMark = 0.35f;  // Å

}  // namespace

void SelectionMarks::set(const SelectedItems& selected) {
  if (selected == selected_) return;
  selected_ = selected;
  draw();
}

BallGeometry SelectionMarks::places(const SelectedItems& items) const {
  BallGeometry places;
  if (!picture_.molecule) return places;
  const auto add = [&places](const BallGeometry& from, std::size_t i) {
    places.centres.push_back(from.centres.at(i));
    places.radii.push_back(from.radii.at(i));
  };
  for (const BallIndex ball : items.balls) add(*picture_.molecule->geometry, ball);
  for (const std::size_t i : items.beside) add(*beside_.body().mesh->opaque.spheres, i);
  return places;
}

void SelectionMarks::draw() {
  Scene& scene = canvas_.change();
  if (!picture_.molecule) return;
  const std::vector<float>& drawn = picture_.parts.radii;
  SelectedItems seen = selected_;
  if (const auto& looks = picture_.parts.looks) {
    std::erase_if(seen.balls, [&looks](BallIndex ball) { return looks->hides(ball); });
  }
  auto marks = std::make_shared<BallGeometry>(places(seen));
  std::vector<float> radii;
  for (std::size_t i = 0; i < marks->centres.size(); ++i) {
    const float radius = i < seen.balls.size() ? drawn.at(seen.balls[i]) : marks->radii[i];
    radii.push_back(std::max(kLeastMark, radius * kMarkScale + kMarkRim));
  }
  marks->radii = radii;
  const std::vector<Rgb8> colours(radii.size(), to_rgb8(palette(canvas_.style().theme).selected));
  scene.set_selected(radii.empty() ? nullptr : make_ball_data(marks, colours, radii),
                     seen.outlines);
}

}  // namespace alphascope
