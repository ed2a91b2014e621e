// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the tree, orders scattered things along a Morton curve, and intersects rays with boxes.
#include "ui/scene/pick/box_tree.hpp"

#include <cmath>
#include <utility>

namespace alphascope {
namespace {

constexpr int kBits = 7;  // of a Morton code, along each axis

double diagonal(const Box& box) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = double{box.high[k]} - box.low[k];
    square += side * side;
  }
  return std::sqrt(square);
}

}  // namespace

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

void BoxTree::add_levels(Boxes leaves, const CancelToken& cancel) {
  levels_.clear();
  levels_.push_back(std::move(leaves));
  while (levels_.back().size() > 1) {
    const Boxes& below = levels_.back();
    Boxes boxes = boxes_around(
        below.size(), [&](std::size_t i) { return below[i]; }, cancel);
    levels_.push_back(std::move(boxes));
  }
}

// Compares the leaves with boxes that divide the whole box evenly. Leaves of atoms along chains are
// less than twice as large as those. Leaves of atoms in random order are about as large as the
// whole box.
bool BoxTree::is_scattered() const {
  constexpr double kMuchLarger = 8;
  const Boxes& leaves = levels_.front();
  double sum = 0;
  for (const Box& leaf : leaves) sum += diagonal(leaf);
  const double leaf_count = static_cast<double>(leaves.size());
  const double ordered = diagonal(levels_.back().front()) / std::cbrt(leaf_count);
  return sum / leaf_count > kMuchLarger * ordered;
}

std::uint32_t BoxTree::place_on_curve(const Box& box, const Box& all) {
  std::uint32_t code = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float side = all.high[k] - all.low[k];
    const float share = side > 0 ? (0.5f * (box.low[k] + box.high[k]) - all.low[k]) / side : 0.0f;
    constexpr std::uint32_t kCells = 1u << kBits;
    const auto cell =
        std::min(kCells - 1, static_cast<std::uint32_t>(std::max(0.0f, share) * kCells));
    for (int bit = 0; bit < kBits; ++bit) {
      code |= ((cell >> bit) & 1u) << (3 * bit + static_cast<int>(k));
    }
  }
  return code;
}

// Counting sort, in three passes.
void BoxTree::sort_by(const ResultArray<std::uint32_t>& places) {
  std::vector<std::uint32_t> start((std::size_t{1} << (3 * kBits)) + 1, 0);
  for (const std::uint32_t place : places) ++start[place + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  order_.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    order_[start[places[i]]++] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace alphascope
