// SPDX-License-Identifier: GPL-3.0-or-later
// Labels at points of the molecule, and the pixels where a picture shows them. No VTK.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ui/picture_marks.hpp"
#include "ui/scene/camera.hpp"
#include "ui/scene/cut.hpp"

namespace alphascope {

struct PlacedLabel {
  std::array<double, 3> at{};  // Å, relative to BallGeometry::origin
  std::string text;
};

// The labels in front of the viewer that the cut keeps, nearest first. They may lie outside a
// picture of this size (pixels).
std::vector<PictureLabel> labels_seen(const std::vector<PlacedLabel>& labels,
                                      const ViewFrustum& sight, const Cut& cut, int width,
                                      int height);

}  // namespace alphascope
