// SPDX-License-Identifier: GPL-3.0-or-later
// The camera of the picture: moves, named views, and the view that other balls get.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "core/document/session/session_file.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/clip_handle.hpp"
#include "ui/panels/viewport_info.hpp"

namespace alphascope {

class Cameras {
 public:
  Cameras(Canvas& canvas, const DrawnPicture& picture) : canvas_(canvas), picture_(picture) {}

  void reset() { canvas_.change().reset_view(); }
  // Call before an action that starts from the present view. It fits the view to a new molecule at
  // once, and not with the first picture.
  void settle(const ViewportInfo& viewport);
  // The present view, or the end of a glide; nothing if no molecule is drawn.
  std::optional<CameraPlace> place() const;
  // The view of saved pictures, as Scene::viewpoint_of_pictures().
  std::optional<CameraPlace> place_of_pictures() const;
  void move(const CameraPlace& camera);

  // Looks at the same point from this side, at the same distance. `towards_viewer` is a unit
  // vector.
  void look_from(const std::array<double, 3>& towards_viewer);
  // Turns the view until it is normal to this line (a unit vector), as side_across() does.
  void look_across(const RealPoint& line);
  void zoom(double factor);
  // Moves the view until these balls fill it. Its direction stays.
  void zoom_to(const BallGeometry& balls);
  // Moves the view's centre of rotation to the middle of these balls. Direction and scale stay.
  void centre_on(const BallGeometry& balls);

  // Carries out a move of the view by the program. With glides on, the picture follows in about 0.3
  // s, and all but the picture sees the new view at once.
  void glide(const std::function<void()>& move);
  void set_glides(bool glides);  // off: moves are jumps, and a glide ends
  bool gliding() const { return glide_.has_value(); }
  // Call once a frame while gliding.
  void step_glide(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  void end_glide();
  // Call before the picture is cleared for good: the next molecule gets a view of its own.
  void forget() {
    end_glide();
    viewed_ = nullptr;
    when_drawn_.reset();
    left_.reset();
  }  // at its end

  NamedView named(const std::string& name) const;
  void go_to(const NamedView& view);

  // The line of sight through a pixel of the picture, Å in the file's coordinates. Nothing if there
  // is no picture.
  std::optional<Ray> ray(int x, int y) const;
  // The handle for the picture on screen. `size` as in make_clip_handle().
  ClipHandle clip_handle(const Clip& clip, const std::array<double, 3>& pivot, double size) const;

  // Sets the view for the next picture with other balls. Nothing: the view then shows all of them.
  void set_when_drawn(const std::optional<CameraPlace>& camera) { when_drawn_ = camera; }
  // Returns once the view that was left when other atoms of the file were fitted into the picture;
  // then nothing.
  std::optional<CameraPlace> take_left() { return std::exchange(left_, std::nullopt); }

  // Whether the view was set for the atoms of this molecule.
  bool is_set_for(const OpenedMolecule& opened) const;

  // The view while the picture gets other balls. The scene's origin is the middle of all balls,
  // which may move.
  struct Before {
    bool keep = false;       // the new balls are atoms of the same molecule
    bool same_file = false;  // or of the same file
    std::optional<CameraPlace> camera;
    std::optional<NamedView> view;  // to go back to
  };
  Before before(const DrawnMolecule& next);  // ends a glide
  // Call when the new balls are in the scene. The view stays for other atoms of the same molecule,
  // unless `problem` says that it shows none of them.
  void follow(const Before& before, const std::function<ViewProblem()>& problem);

 private:
  Canvas& canvas_;
  const DrawnPicture& picture_;
  std::shared_ptr<const OpenedMolecule> viewed_;  // the molecule for which the view was set
  std::optional<CameraPlace> left_;
  std::optional<CameraPlace> when_drawn_;
  struct Glide {
    Viewpoint from, to;
    std::chrono::steady_clock::time_point since;
  };
  std::optional<Glide> glide_;
  bool glides_ = false;
};

}  // namespace alphascope
