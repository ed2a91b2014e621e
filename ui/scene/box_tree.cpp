// See the header.
#include "ui/scene/box_tree.hpp"

namespace alphascope {

bool meets(const Ray& ray, const Box& box, double margin, double farthest) {
  double from = 0, to = farthest;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = double{box.low[k]} - margin - ray.start[k],
                 high = double{box.high[k]} + margin - ray.start[k];
    if (ray.direction[k] == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const double a = low / ray.direction[k], b = high / ray.direction[k];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

void BoxTree::add_level() {
  const std::vector<Box>& below = levels_.back();
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < below.size(); ++i) {
    if (i % kFan == 0) boxes.push_back(Box::empty());
    boxes.back().add(below[i]);
  }
  levels_.push_back(std::move(boxes));
}

}  // namespace alphascope
