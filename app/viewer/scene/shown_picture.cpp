// SPDX-License-Identifier: GPL-3.0-or-later
// Exchanges the parts of the picture, and lets each follow the controls.
#include "app/viewer/scene/shown_picture.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/radii/radii_set.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"

namespace alphascope {
namespace {

// Whether the clip keeps a part of any ball.
bool keeps_any(const Cut& cut, const BallGeometry& balls) {
  for (std::size_t i = 0; i < balls.centres.size(); ++i) {
    const bool kept = std::all_of(cut.kept.begin(), cut.kept.end(), [&](const HalfSpace& space) {
      return space.depth(balls.centres[i]) >= -balls.radii[i];
    });
    if (kept) return true;
  }
  return false;
}

}  // namespace

ShownPicture::ShownPicture(const std::function<void()>& wake, std::chrono::milliseconds finishes,
                           const FreeMemory& free_memory, const SceneControls& controls)
    : controls_(controls),
      beside_(wake, canvas_, picture_, facts_),
      objects_(wake, free_memory, canvas_, picture_, facts_),
      layers_(wake, free_memory, canvas_, picture_, facts_),
      picking_(wake, canvas_, picture_),
      caps_(wake, finishes, canvas_, picture_),
      colours_(wake, canvas_, picture_) {
  restyle();  // follow_display() later sends changes only
}

void ShownPicture::restyle() {
  SceneStyle style = scene_style(controls_.display, controls_.theme);
  style.line_scale = controls_.line_scale;
  style.cut = picture_.cut();
  canvas_.set_style(style);
}

void ShownPicture::follow_display(const SceneControls& before) {
  const DisplaySettings &was = before.display, &is = controls_.display;
  canvas_.change();
  restyle();
  if (was.ball_paint != is.ball_paint) colours_.make(is.ball_paint);
  if (before.theme != controls_.theme) marks_.draw();
  if (was.ball_scale != is.ball_scale || was.grown_balls != is.grown_balls) update_radii();
  if (was.beside != is.beside) follow_beside();
}

void ShownPicture::show(Drawing drawing) {
  pacing_.take_time(true);
  const bool new_balls = !has_same_balls(picture_.molecule.get(), *drawing.molecule);
  if (new_balls && !drawing.balls) {
    make_balls(drawing);
  } else if (!new_balls) {
    drawing.molecule = picture_.molecule;
    drawing.balls = nullptr;
  }
  const Cameras::Before view = cameras_.before(*drawing.molecule);
  // Only the first mesh of an answer has the time for its outer faces. Later meshes reuse the faces
  // that the device found.
  const bool first_of_answer = picture_.answer != drawing.answer && drawing.answer;
  pacing_.begin_picture(drawing.parts.mesh_milliseconds +
                        (first_of_answer ? drawing.answer->outer_faces_milliseconds : 0));
  exchange_parts(drawing, new_balls);
  picking_.follow_mesh();
  Scene& scene = canvas_.change();
  scene.set_mesh(std::move(drawing.mesh));
  caps_.show_new(std::move(drawing.caps));
  scene.set_differences(std::move(drawing.differences));
  if (!new_balls) return;
  beside_.follow(controls_);
  objects_.follow(controls_);
  if (!view.keep) pacing_.forget_times();
  cameras_.follow(view, [this] { return view_problem(); });
}

// Makes balls for a drawing that has none. It was begun when its balls were on screen, and they no
// longer are.
void ShownPicture::make_balls(Drawing& drawing) const {
  const DrawnMolecule& m = *drawing.molecule;
  DrawnParts& parts = drawing.parts;
  set_radii(parts, m, drawing.answer.get(), controls_.display);
  drawing.balls =
      make_ball_data(m.geometry, parts.ball_colours(m.geometry->centres.size()), parts.radii);
}

void ShownPicture::exchange_parts(Drawing& drawing, bool new_balls) {
  DrawnParts before = std::exchange(picture_.parts, std::move(drawing.parts));
  DrawnParts& parts = picture_.parts;
  picture_.answer = drawing.answer;
  picture_.not_drawn = std::move(drawing.not_drawn);
  picture_.molecule = std::move(drawing.molecule);
  parts.clip = before.clip;        // until the caps are exchanged
  if (new_balls) forget_layers();  // layers belong to their balls
  const bool new_painting = before.paintings.balls != parts.paintings.balls && !new_balls;
  // Each drawing makes looks of its own, so their pointers do not tell whether they differ.
  const bool new_looks = (before.looks || parts.looks) && !new_balls;
  if (new_balls || controls_.display.grown_balls) {
    show_balls(std::move(drawing.balls));
  } else {
    parts.ball_scale = before.ball_scale;
    parts.grown_balls = before.grown_balls;
    parts.radii = std::move(before.radii);
  }
  if (new_painting || new_looks) colours_.show();
  const auto& painting = parts.paintings.balls;
  const Paint& wanted = controls_.display.ball_paint;
  if (painting && painting->paint != wanted) colours_.make(wanted);
  if (new_looks) update_radii();
}

// Colours and radii come with the drawing, unless the controls have changed since its start.
void ShownPicture::show_balls(std::shared_ptr<BallData> balls) {
  const DrawnParts& parts = picture_.parts;
  const bool radii_fit = parts.ball_scale == controls_.display.ball_scale &&
                         parts.grown_balls == controls_.display.grown_balls &&
                         parts.radii.size() == picture_.molecule->geometry->centres.size();
  const bool with_radii = balls != nullptr;
  if (with_radii) canvas_.change().set_balls(std::move(balls));
  if (!radii_fit) return update_radii();
  if (!with_radii) canvas_.change().set_ball_radii(parts.radii);
  follow_radii();
}

void ShownPicture::update_radii() {
  if (!picture_.molecule) return;
  DrawnParts& parts = picture_.parts;
  set_radii(parts, *picture_.molecule, picture_.answer.get(), controls_.display);
  canvas_.change().set_ball_radii(parts.radii);
  follow_radii();
}

void ShownPicture::follow_radii() {
  picking_.follow_radii();
  marks_.draw();
}

void ShownPicture::clear() {
  forget_layers();
  canvas_.drawing().set_balls(std::make_shared<const BallGeometry>(), {});
  const Clip clip = picture_.parts.clip;
  const std::string not_drawn = picture_.not_drawn;
  picture_ = {};
  picture_.parts.clip = clip;
  picture_.not_drawn = not_drawn;
  caps_.forget();
  picking_.forget();
}

void ShownPicture::forget_layers() {
  beside_.forget();
  objects_.forget();
  marks_.forget();
  layers_.forget();
}

std::optional<Hit> ShownPicture::pick(int x, int y, double near) const {
  PickLayers others;
  if (caps_.pick()) others.push_back(*caps_.pick());
  if (beside_.pick()) others.push_back(*beside_.pick());
  others.insert(others.end(), objects_.picks().begin(), objects_.picks().end());
  others.insert(others.end(), layers_.picks().begin(), layers_.picks().end());
  return picking_.pick(x, y, near, layers_.picked_first(), others);
}

ViewProblem ShownPicture::view_problem() const {
  if (!picture_.any()) return ViewProblem::none;
  const DrawnParts& parts = picture_.parts;
  const bool complex = picture_.shows_complex(), balls = canvas_.style().balls;
  const BallGeometry& geometry = *picture_.molecule->geometry;
  const std::vector<float>& radii = parts.radii;
  const Cut& cut = canvas_.style().cut;
  if (cut.on() && !keeps_any(cut, geometry)) return ViewProblem::cut_away;
  if (!complex && parts.looks && parts.looks->hidden_balls > 0) {
    const bool any_ball =
        balls && std::any_of(radii.begin(), radii.end(), [](float radius) { return radius > 0; });
    if (!any_ball)
      return beside_.body().mesh || objects_.any() ? ViewProblem::none : ViewProblem::all_hidden;
  }
  if (!complex && (!balls || objects_.any())) return ViewProblem::none;  // nothing is switched on
  return alphascope::view_problem(geometry, balls ? radii : std::vector<float>(),
                                  canvas_.scene().sight(), complex);
}

void ShownPicture::poll() {
  layers_.poll();
  beside_.poll();
  objects_.poll();
  picking_.poll();
  caps_.poll();
  colours_.poll();
}

bool ShownPicture::busy() const {
  return layers_.busy() || beside_.busy() || objects_.busy() || picking_.busy() || caps_.busy() ||
         colours_.busy();
}

std::uint64_t ShownPicture::bytes() const {
  if (!picture_.molecule) return 0;
  return drawn_bytes(picture_.molecule->geometry->centres.size(), picture_.parts.mesh.get()) +
         layers_.bytes() + objects_.bytes();
}

}  // namespace alphascope
