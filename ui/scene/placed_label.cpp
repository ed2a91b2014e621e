// See the header.
#include "ui/scene/placed_label.hpp"

#include <algorithm>
#include <utility>

namespace alphascope {

std::vector<PictureLabel> labels_seen(const std::vector<PlacedLabel>& labels, const Sight& sight,
                                      int width, int height) {
  std::vector<std::pair<double, PictureLabel>> seen;
  for (const PlacedLabel& label : labels) {
    double right = 0, up = 0, ahead = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double offset = label.at[k] - sight.position[k];
      right += offset * sight.right[k];
      up += offset * sight.up[k];
      ahead += offset * sight.forward[k];
    }
    if (!(ahead > 0)) continue;
    const double x = (1 + right / (ahead * sight.tangent_right)) / 2 * width;
    const double y = (1 - up / (ahead * sight.tangent_up)) / 2 * height;
    seen.push_back({ahead, {static_cast<float>(x), static_cast<float>(y), label.text}});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PictureLabel> result;
  for (auto& [depth, label] : seen) result.push_back(std::move(label));
  return result;
}

}  // namespace alphascope
