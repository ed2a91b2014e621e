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
#include <utility>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/parallel.hpp"

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
  // `box_of(i)` gives the box of each of the `count` things; several threads call it. They are
  // those of the caller's task arena. Throws Cancelled.
  template <class BoxOf>
  BoxTree(std::size_t count, const BoxOf& box_of, const CancelToken& cancel = {}) : count_(count) {
    if (count == 0) return;
    add_leaves(box_of, cancel);
    if (!is_scattered()) return;
    const Box all = levels_.back().front();
    ResultArray<std::uint32_t> places(count);
    parallel_many(count, cancel,
                  [&](std::size_t i) { places[i] = place_on_curve(box_of(i), all); });
    sort_by(places);
    add_leaves(box_of, cancel);
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

  using Boxes = ResultArray<Box>;

  // The boxes of sixteen consecutive ones of `count` boxes each.
  template <class BoxAt>
  static Boxes boxes_around(std::size_t count, const BoxAt& box_at, const CancelToken& cancel) {
    Boxes boxes((count + kFan - 1) / kFan);
    parallel_many(boxes.size(), cancel, [&](std::size_t n) {
      Box box = Box::empty();
      for (std::size_t i = n * kFan; i < std::min(count, (n + 1) * kFan); ++i) box.add(box_at(i));
      boxes[n] = box;
    });
    return boxes;
  }
  template <class BoxOf>
  void add_leaves(const BoxOf& box_of, const CancelToken& cancel) {
    add_levels(boxes_around(
                   count_, [&](std::size_t i) { return box_of(thing(i)); }, cancel),
               cancel);
  }
  void add_levels(Boxes leaves, const CancelToken& cancel);
  // Whether the leaves are much larger than those of an ordered list.
  bool is_scattered() const;
  // Position of the box along a curve that fills `all`: a Morton code.
  static std::uint32_t place_on_curve(const Box& box, const Box& all);
  void sort_by(const ResultArray<std::uint32_t>& places);

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
  std::vector<std::uint32_t> order_;  // empty: things are in the given order
  std::vector<Boxes> levels_;         // the last has one box
};

}  // namespace alphascope
