// SPDX-License-Identifier: GPL-3.0-or-later
// When and how finely the picture is drawn: coarsely while something moves, finer at rest. Measures
// the time of pictures.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "app/viewer/scene/ball_stand_in.hpp"
#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"
#include "core/run/stage_timer.hpp"
#include "ui/scene/quality.hpp"

namespace alphascope {

class Pacing {
 public:
  static constexpr double kNotDue = 1e9;  // seconds

  Pacing(Canvas& canvas, const DrawnPicture& picture) : canvas_(canvas), picture_(picture) {}

  // Call when the picture gets another complex. The time limit for outdated pictures starts anew.
  void begin_picture(double mesh_milliseconds);
  // Call for another molecule, whose pictures take other times.
  void forget_times();
  // Whether a picture was begun that is not drawn yet.
  bool has_new_picture() const { return new_picture_ && canvas_.changed(); }
  // To be called in each frame. `outdated`: the picture is older than the settings. Returns whether
  // it has been so for 300 ms. Marking the pictures of a moving slider sooner would flicker.
  bool note_age(bool outdated);

  // Draws after a change, or when a finer picture is due. Returns whether it drew. `pending`: the
  // picture will soon be replaced. `patient`: at the finest quality, however long it takes.
  bool draw_when_due(bool interacting, bool pending, bool patient);
  // Notes the time of a picture that the GPU may still be drawing. Call before a change on which
  // the time depends.
  void take_time(bool wait);
  // Milliseconds that a picture of a moving view takes.
  double moving_milliseconds() const { return quality_.moving_milliseconds(); }
  bool wants_frame() const { return canvas_.changed() || refine_; }
  // Seconds until a finer picture is due, or kNotDue.
  double seconds_to_refinement() const;

  // Milliseconds for mesh, upload and drawing of the first picture of the complex on screen. Until
  // that picture is drawn, only the mesh's time is there.
  const std::vector<StageTime>& stages() const { return stages_; }
  using Clock = std::chrono::steady_clock;
  // When the first picture of the complex on screen was finished; nothing until its time is known.
  std::optional<Clock::time_point> finished() const;

 private:
  RenderQuality quality_for_change(bool follows_computation) const;
  void choose_stand_in(bool at_rest);
  void draw(RenderQuality quality, bool patient);
  bool unfinished() const;  // the picture on screen could get more samples
  void note_times(RenderQuality quality, double picture_milliseconds);

  Canvas& canvas_;
  const DrawnPicture& picture_;
  QualityChooser quality_;
  BallStandIn balls_;
  RenderQuality drawn_ = RenderQuality::draft;
  bool refine_ = false;       // the picture on screen could be finer
  bool new_picture_ = false;  // a picture of another complex was begun and is not drawn yet
  std::optional<Clock::time_point> outdated_since_;
  Clock::time_point last_change_ = Clock::now();
  Clock::time_point drawing_since_ = last_change_;  // the first picture of the complex
  std::vector<StageTime> stages_;
};

}  // namespace alphascope
