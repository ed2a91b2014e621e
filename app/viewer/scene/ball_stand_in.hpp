// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether balls are left out of pictures while the view moves, because drawing them takes
// too long. The complex then stands in for the balls. Pure logic.
#pragma once

#include "ui/scene/quality.hpp"

namespace alphascope {

class BallStandIn {
 public:
  // Limit for the coarsest picture with balls, milliseconds.
  static constexpr double kMost = 100;

  // Notes the time of a picture with balls, milliseconds. Pictures finer than drafts are ignored.
  void note(RenderQuality quality, double milliseconds) {
    if (quality > RenderQuality::draft) return;
    slow_ = milliseconds * (quality == RenderQuality::draft ? kSketchOfDraft : 1) > kMost;
  }
  // Call for other balls or another size of the window.
  void forget() { slow_ = false; }
  // `other`: the picture also holds something else that shows where the molecule is.
  bool wanted(bool at_rest, bool other) const { return slow_ && !at_rest && other; }

 private:
  // Assumed time of a sketch as a share of a draft's.
  static constexpr double kSketchOfDraft = 0.3;
  bool slow_ = false;
};

}  // namespace alphascope
