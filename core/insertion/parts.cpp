// SPDX-License-Identifier: GPL-3.0-or-later
// Halves a sample of the balls again and again, across its longest direction.
#include "core/insertion/parts.hpp"

#include <algorithm>
#include <iterator>

namespace alphascope {

Parts::Parts(std::size_t count, int turn, std::span<const InsertedBall> all,
             std::span<const std::uint32_t> balls) {
  constexpr std::size_t kSamples = 256;  // for each part
  // Each row has three directions at right angles.
  static constexpr Direction kDirections[][3] = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{2. / 3, 2. / 3, 1. / 3}, {-2. / 3, 1. / 3, 2. / 3}, {1. / 3, -2. / 3, 2. / 3}},
      {{2. / 7, 3. / 7, 6. / 7}, {3. / 7, -6. / 7, 2. / 7}, {6. / 7, 2. / 7, -3. / 7}},
      {{1. / 9, 4. / 9, 8. / 9}, {4. / 9, 7. / 9, -4. / 9}, {8. / 9, -4. / 9, 1. / 9}},
      {{-2. / 3, 2. / 3, 1. / 3}, {2. / 3, 1. / 3, 2. / 3}, {1. / 3, 2. / 3, -2. / 3}},
      {{2. / 7, -3. / 7, 6. / 7}, {-3. / 7, -6. / 7, -2. / 7}, {6. / 7, -2. / 7, -3. / 7}}};
  const std::size_t samples = std::min(balls.size(), kSamples * count);
  std::vector<InsertedBall> sample(samples);
  for (std::size_t n = 0; n < samples; ++n) sample[n] = all[balls[n * balls.size() / samples]];
  split(std::min(count, kMost),
        kDirections[static_cast<std::size_t>(turn) % std::size(kDirections)], sample);
}

void Parts::split(std::size_t count, std::span<const Direction> directions,
                  std::span<InsertedBall> sample) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  if (count < 2 || sample.empty()) {
    nodes_[node].part = parts_++;
    return;
  }
  double longest = -1;
  Direction direction = directions[0];
  for (const Direction& d : directions) {
    const auto [low, high] = std::minmax_element(
        sample.begin(), sample.end(),
        [&](const InsertedBall& a, const InsertedBall& b) { return along(d, a) < along(d, b); });
    const double length = along(d, *high) - along(d, *low);
    if (length > longest) {
      longest = length;
      direction = d;
    }
  }
  const std::size_t lower = count / 2;
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() * lower / count);
  std::nth_element(sample.begin(), middle, sample.end(),
                   [&](const InsertedBall& a, const InsertedBall& b) {
                     return along(direction, a) < along(direction, b);
                   });
  nodes_[node].direction = direction;
  nodes_[node].at = along(direction, *middle);
  const auto below = static_cast<std::size_t>(middle - sample.begin());
  split(lower, directions, sample.first(below));
  nodes_[node].high = static_cast<std::int32_t>(nodes_.size());
  split(count - lower, directions, sample.subspan(below));
}

}  // namespace alphascope
