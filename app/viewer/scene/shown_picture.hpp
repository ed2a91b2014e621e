// SPDX-License-Identifier: GPL-3.0-or-later
// The picture on screen, and the classes that each keep one part of it up to date. A new drawing
// replaces all of its parts in one step.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/viewer/beside/beside_atoms.hpp"
#include "app/viewer/beside/made_objects.hpp"
#include "app/viewer/scene/ball_colours.hpp"
#include "app/viewer/scene/cameras.hpp"
#include "app/viewer/scene/clip_caps.hpp"
#include "app/viewer/scene/drawing_maker.hpp"
#include "app/viewer/scene/pacing.hpp"
#include "app/viewer/scene/panel_layers.hpp"
#include "app/viewer/scene/picking.hpp"
#include "app/viewer/scene/scene_controls.hpp"
#include "app/viewer/scene/selection_marks.hpp"
#include "ui/view_problem.hpp"

namespace alphascope {

class ShownPicture {
 public:
  // `wake` and `finishes` as in Worker. `controls` are the present ones.
  ShownPicture(const std::function<void()>& wake, std::chrono::milliseconds finishes,
               const FreeMemory& free_memory, const SceneControls& controls);

  // Replaces the picture. A drawing may arrive after others that were begun later. Its result
  // follows from its own data and the controls, not from the picture at its start.
  void show(Drawing drawing);
  // Removes the picture from the scene. The last image stays.
  void clear();
  void forget_not_drawn() { picture_.not_drawn.clear(); }
  // Follows the controls after a change of these.
  void follow_display(const SceneControls& before);
  void follow_beside() { beside_.follow(controls_); }
  void follow_objects() { objects_.follow(controls_); }

  const DrawnPicture& drawn() const { return picture_; }
  Canvas& canvas() { return canvas_; }
  const Canvas& canvas() const { return canvas_; }
  Cameras& cameras() { return cameras_; }
  const Cameras& cameras() const { return cameras_; }
  ClipCaps& caps() { return caps_; }
  const MadeObjects& objects() const { return objects_; }
  PanelLayers& layers() { return layers_; }
  const PanelLayers& layers() const { return layers_; }
  Pacing& pacing() { return pacing_; }
  const Pacing& pacing() const { return pacing_; }
  // The drawn atoms that are not balls.
  const BesideBody& beside_body() const { return beside_.body(); }

  // The item drawn under a pixel of the picture. `near`: distance in pixels at which a line is
  // still hit.
  std::optional<Hit> pick(int x, int y, double near) const;
  void set_selected(const SelectedItems& selected) { marks_.set(selected); }
  // Move the camera: SelectedItems as in Cameras::zoom_to() and centre_on().
  void zoom_to(const SelectedItems& items) { cameras_.zoom_to(marks_.places(items)); }
  void centre_on(const SelectedItems& items) { cameras_.centre_on(marks_.places(items)); }
  // Whether the view shows anything, and otherwise why not.
  ViewProblem view_problem() const;

  void poll();
  bool busy() const;
  bool is_due() const { return picking_.is_due(); }  // one of the next polls begins work
  // Upper bound of the bytes of the picture, without differences.
  std::uint64_t bytes() const;

 private:
  void restyle();
  void forget_layers();
  void make_balls(Drawing& drawing) const;
  void exchange_parts(Drawing& drawing, bool new_balls);
  void show_balls(std::shared_ptr<BallData> balls);
  void update_radii();
  void follow_radii();

  const SceneControls& controls_;
  Canvas canvas_;
  DrawnPicture picture_;
  Cameras cameras_{canvas_, picture_};
  Pacing pacing_{canvas_, picture_};
  FactsOnce facts_;
  BesideAtoms beside_;
  SelectionMarks marks_{canvas_, picture_, beside_};
  MadeObjects objects_;
  PanelLayers layers_;
  Picking picking_;
  ClipCaps caps_;
  BallColours colours_;
};

}  // namespace alphascope
