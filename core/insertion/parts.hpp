// SPDX-License-Identifier: GPL-3.0-or-later
// Space in parts of about equally many balls, between planes. They only share out the work.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/insertion/cell.hpp"

namespace alphascope {

class Parts {
 public:
  static constexpr std::size_t kMost = 128;

  // `balls` are those to share out: places in `all`. Another `turn` has other planes, which cross
  // those of the turns before.
  Parts(std::size_t count, int turn, std::span<const InsertedBall> all,
        std::span<const std::uint32_t> balls);

  std::uint8_t part_of(const InsertedBall& ball) const {
    std::int32_t at = 0;
    while (nodes_[static_cast<std::size_t>(at)].high >= 0) {
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      at = along(node.direction, ball) < node.at ? at + 1 : node.high;
    }
    return nodes_[static_cast<std::size_t>(at)].part;
  }

 private:
  using Direction = std::array<double, 3>;
  // A plane, with the node of what is below it next to it; or a part.
  struct Node {
    Direction direction{};
    double at = 0;
    std::int32_t high = -1;
    std::uint8_t part = 0;
  };
  static double along(const Direction& d, const InsertedBall& ball) {
    return d[0] * ball.x + d[1] * ball.y + d[2] * ball.z;
  }
  void split(std::size_t count, std::span<const Direction> directions,
             std::span<InsertedBall> sample);

  std::vector<Node> nodes_;
  std::uint8_t parts_ = 0;
};

}  // namespace alphascope
