// Whether balls are left to the picture at rest, because a picture with them comes too late while
// something moves; what else is drawn stands in for them. Pure logic.
#pragma once

#include "ui/scene/quality.hpp"

namespace alphascope {

class BallStandIn {
 public:
  // Milliseconds that the coarsest picture with balls may take.
  static constexpr double kMost = 100;

  // Of a picture with balls, in milliseconds; finer ones say nothing that the coarse ones do not.
  void note(RenderQuality quality, double milliseconds) {
    if (quality > RenderQuality::draft) return;
    slow_ = milliseconds * (quality == RenderQuality::draft ? kSketchOfDraft : 1) > kMost;
  }
  // Other balls, another window.
  void forget() { slow_ = false; }
  // `other`: something else shows where the molecule is.
  bool wanted(bool at_rest, bool other) const { return slow_ && !at_rest && other; }

 private:
  static constexpr double kSketchOfDraft = 0.3;  // of its time, as in QualityChooser
  bool slow_ = false;
};

}  // namespace alphascope
