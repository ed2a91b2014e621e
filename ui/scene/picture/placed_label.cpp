// SPDX-License-Identifier: GPL-3.0-or-later
// Projects labels into a picture.
#include "ui/scene/picture/placed_label.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/alpha.hpp"

namespace alphascope {

std::vector<PictureLabel> labels_seen(const std::vector<PlacedLabel>& labels,
                                      const ViewFrustum& sight, const Cut& cut, int width,
                                      int height) {
  std::vector<std::pair<double, PictureLabel>> seen;
  for (const PlacedLabel& label : labels) {
    if (!cut.keeps(label.at)) continue;
    const auto place = project_point(sight, label.at, width, height);
    if (!place) continue;
    const double ahead =
        std::hypot(label.at[0] - sight.position[0], label.at[1] - sight.position[1],
                   label.at[2] - sight.position[2]);
    seen.push_back(
        {ahead, {static_cast<float>((*place)[0]), static_cast<float>((*place)[1]), label.text}});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PictureLabel> result;
  for (auto& [depth, label] : seen) result.push_back(std::move(label));
  return result;
}

}  // namespace alphascope
