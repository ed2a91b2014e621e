// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of boxes, so that a ray is tried against a few things only (balls, triangles, lines). A
// box surrounds sixteen consecutive things, the next level sixteen of these boxes, and so on. Files
// list atoms along chains and meshes follow the atoms, so neighbours in the list are mostly
// neighbours in space. Only a list without such an order is sorted.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace alphascope {

// A ray in Å, relative to BallGeometry::origin. The direction need not have unit length.
struct Ray {
  std::array<double, 3> start{};
  std::array<double, 3> direction{0, 0, -1};
};

struct Box {
  std::array<float, 3> low, high;

  static Box empty() {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  }
  void add(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
};

// Whether the ray meets the box between its start and `farthest` (in lengths of the direction). The
// box is enlarged by `margin` (Å) on all sides.
bool meets(const Ray& ray, const Box& box, double margin, double farthest);

class BoxTree {
 public:
  BoxTree() = default;
  // `box_of(i)` gives the box of each of the `count` things.
  template <class BoxOf>
  BoxTree(std::size_t count, const BoxOf& box_of) : count_(count) {
    if (count == 0) return;
    add_leaves(box_of);
    if (!is_scattered()) return;
    const Box all = levels_.back().front();
    std::vector<std::uint32_t> places(count);
    for (std::size_t i = 0; i < count; ++i) places[i] = place_on_curve(box_of(i), all);
    sort_by(places);
    add_leaves(box_of);
  }

  std::size_t size() const { return count_; }

  // Calls `test(i)` for all things in boxes for which `enter(box)` returns true. Each call may
  // change the results of later calls.
  template <class Enter, class Test>
  void visit(const Enter& enter, const Test& test) const {
    if (!levels_.empty()) visit_node(levels_.size() - 1, 0, enter, test);
  }

 private:
  static constexpr std::size_t kFan = 16;

  std::size_t thing(std::size_t i) const { return order_.empty() ? i : order_[i]; }

  template <class BoxOf>
  void add_leaves(const BoxOf& box_of) {
    std::vector<Box> leaves;
    leaves.reserve((count_ + kFan - 1) / kFan);
    for (std::size_t i = 0; i < count_; ++i) {
      if (i % kFan == 0) leaves.push_back(Box::empty());
      leaves.back().add(box_of(thing(i)));
    }
    add_levels(std::move(leaves));
  }
  void add_levels(std::vector<Box> leaves);
  // Whether the leaves are much larger than those of an ordered list.
  bool is_scattered() const;
  // Position of the box along a curve that fills `all`: a Morton code.
  static std::uint32_t place_on_curve(const Box& box, const Box& all);
  void sort_by(const std::vector<std::uint32_t>& places);

  template <class Enter, class Test>
  void visit_node(std::size_t level, std::size_t node, const Enter& enter, const Test& test) const {
    if (!enter(levels_[level][node])) return;
    const std::size_t below = level == 0 ? count_ : levels_[level - 1].size();
    const std::size_t end = std::min(below, (node + 1) * kFan);
    for (std::size_t i = node * kFan; i < end; ++i) {
      if (level == 0) {
        test(thing(i));
      } else {
        visit_node(level - 1, i, enter, test);
      }
    }
  }

  std::size_t count_ = 0;
  std::vector<std::uint32_t> order_;      // empty: things are in the given order
  std::vector<std::vector<Box>> levels_;  // the last has one box
};

}  // namespace alphascope
