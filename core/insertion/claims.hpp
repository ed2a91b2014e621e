// SPDX-License-Identifier: GPL-3.0-or-later
// Claims on balls, by inserters that work on one triangulation at the same time. No inserter waits
// for a claim, so none can block another.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alphascope {

class Claims {
 public:
  static constexpr std::size_t kMostInserters = 255;

  explicit Claims(std::size_t balls) : holder_(balls, kNobody) {}

  // Inserters have numbers from 1.
  bool has(std::uint8_t inserter, std::uint32_t ball) const {
    return of(ball).load(std::memory_order_relaxed) == inserter;
  }
  // False if another inserter holds the ball. All that the holder before did to the cells of this
  // ball can be seen then.
  bool claim(std::uint8_t inserter, std::uint32_t ball) {
    std::uint8_t nobody = kNobody;
    return of(ball).load(std::memory_order_relaxed) == kNobody &&
           of(ball).compare_exchange_strong(nobody, inserter, std::memory_order_acquire,
                                            std::memory_order_relaxed);
  }
  void release(std::uint32_t ball) { of(ball).store(kNobody, std::memory_order_release); }

 private:
  static constexpr std::uint8_t kNobody = 0;
  std::atomic_ref<std::uint8_t> of(std::uint32_t ball) const {
    return std::atomic_ref(holder_[ball]);
  }

  mutable std::vector<std::uint8_t> holder_;  // of each ball
};

}  // namespace alphascope
