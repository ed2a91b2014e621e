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
  // One slow picture does not count, since its shaders may have been compiled meanwhile.
  void note(RenderQuality quality, double milliseconds) {
    if (quality > RenderQuality::draft) return;
    const bool slow = milliseconds * (quality == RenderQuality::draft ? kSketchOfDraft : 1) > kMost;
    slow_pictures_ = slow ? slow_pictures_ + 1 : 0;
  }
  // Call for other balls or another size of the window.
  void forget() { slow_pictures_ = 0; }
  // `other`: the picture also holds something else that shows where the molecule is.
  bool wanted(bool at_rest, bool other) const { return slow_pictures_ > 1 && !at_rest && other; }

 private:
  // Assumed time of a sketch as a share of a draft's.
  static constexpr double kSketchOfDraft = 0.3;
  int slow_pictures_ = 0;  // in a row
};

}  // namespace alphascope
