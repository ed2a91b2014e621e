// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets that many threads unite at once, without locks. The root of a set is its least
// member, whatever the order of calls.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

#include "core/complex/simplices.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {

class UnionFind {
 public:
  // Each item is a set of its own.
  explicit UnionFind(std::size_t items) : parent_(items) {
    parallel_many(items, {}, [&](std::size_t n) { parent_[n] = static_cast<std::uint32_t>(n); });
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = root(a);
      b = root(b);
      if (a == b) return;
      if (a > b) std::swap(a, b);
      std::uint32_t expected = b;
      if (parent(b).compare_exchange_strong(expected, a, std::memory_order_relaxed)) return;
    }
  }

  // The root of the set of n. A parent is never larger than its child, and is replaced only by one
  // of its own ancestors.
  std::uint32_t root(std::uint32_t n) {
    for (;;) {
      const std::uint32_t up = parent(n).load(std::memory_order_relaxed);
      if (up == n) return n;
      const std::uint32_t above = parent(up).load(std::memory_order_relaxed);
      if (above != up) parent(n).store(above, std::memory_order_relaxed);
      n = above;
    }
  }

 private:
  std::atomic_ref<std::uint32_t> parent(std::uint32_t n) { return std::atomic_ref(parent_[n]); }

  ResultArray<std::uint32_t> parent_;
};

}  // namespace alphascope
