// SPDX-License-Identifier: GPL-3.0-or-later
// Finds balls of least power distance by one pass with a heap for each point.
#include "core/explain/nearest_by_power.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

// Keeps the `count` balls of least power distance among those offered.
class Least {
 public:
  Least(PointAtBall at, const BallSet& balls, std::size_t count)
      : p_(real_point(balls.centres[at.ball])), twice_(2 * at.offset), count_(count) {}

  void offer(const BallSet& balls, BallIndex m) {
    // The squared offset is the same for all balls and left out. At far points it would swallow the
    // differences.
    const RealPoint d = real_point(balls.centres[m]) - p_;
    const double r = balls.radii[m];
    const double power = dot(d, d) - r * r - dot(d, twice_);
    if (power >= most_) return;
    heap_.emplace_back(power, m);
    std::push_heap(heap_.begin(), heap_.end());
    if (heap_.size() > count_) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    if (heap_.size() == count_) most_ = heap_.front().first;
  }
  std::vector<BallIndex> take() {
    std::sort_heap(heap_.begin(), heap_.end());
    std::vector<BallIndex> found;
    for (const auto& [power, m] : heap_) found.push_back(m);
    return found;
  }

 private:
  RealPoint p_, twice_;  // a ball's centre, and twice the vector from it to the point
  std::size_t count_;
  double most_ = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, BallIndex>> heap_;
};

}  // namespace

std::vector<std::vector<BallIndex>> nearest_by_power(const BallSet& balls,
                                                     std::span<const PointAtBall> points,
                                                     std::span<const BallIndex> without,
                                                     std::size_t count) {
  std::vector<Least> least;
  for (const PointAtBall& point : points) least.emplace_back(point, balls, count);
  for (BallIndex m = 0; m < balls.size(); ++m) {
    if (std::binary_search(without.begin(), without.end(), m)) continue;
    for (Least& one : least) one.offer(balls, m);
  }
  std::vector<std::vector<BallIndex>> found;
  for (Least& one : least) found.push_back(one.take());
  return found;
}

}  // namespace alphascope
