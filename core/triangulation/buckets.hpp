// SPDX-License-Identifier: GPL-3.0-or-later
// Items by ball, counted and placed by all threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_index.hpp"

namespace alphascope {

// The bounds of each ball's part in an array that is ordered by balls. Threads count the items of
// each ball, and then place them. So the order within a part is arbitrary.
class Buckets {
 public:
  explicit Buckets(std::size_t balls) : first_(balls + 1, 0) {}

  void count(BallIndex ball, std::uint32_t things) { add(first_[ball + 1], things); }
  void end_counting() {
    for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
    next_.assign(first_.begin(), first_.end() - 1);
  }
  std::uint32_t place_for(BallIndex ball) { return add(next_[ball], 1); }

  std::size_t balls() const { return first_.size() - 1; }
  std::uint32_t begin(std::size_t ball) const { return first_[ball]; }
  std::uint32_t end(std::size_t ball) const { return first_[ball + 1]; }
  std::uint32_t things() const { return first_.back(); }

 private:
  static std::uint32_t add(std::uint32_t& to, std::uint32_t things) {
    return std::atomic_ref(to).fetch_add(things, std::memory_order_relaxed);
  }
  std::vector<std::uint32_t> first_, next_;
};

}  // namespace alphascope
