// Words at places of the molecule, and where a picture shows these places. No VTK.
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

// Those ahead of the viewer that the cut keeps, nearest first; also such as lie beside a picture of
// this size.
std::vector<PictureLabel> labels_seen(const std::vector<PlacedLabel>& labels, const Sight& sight,
                                      const Cut& cut, int width, int height);

}  // namespace alphascope
