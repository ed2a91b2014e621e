// Faults on purpose, for tests: the n-th reservation of memory is refused, or from the n-th CUDA
// call on every one fails, as when a device is lost. Off unless a test switches one on; one process
// at a time.
#pragma once

#include <atomic>
#include <cstddef>

namespace alphascope::gpu {

struct Faults {
  // Counted down to 0 by what they are about; below 0: off.
  static inline std::atomic<int> refuse_reservation{-1}, lose_device{-1};
  static inline std::atomic<int> met{0};  // faults so far
  // No fault, but what otherwise needs large sets: pages of our own for any pinned memory.
  static inline std::atomic<bool> pins_little{false};
  // Bytes of pinned memory that there are now.
  static inline std::atomic<std::size_t> pinned_bytes{0};

  static void none() {
    refuse_reservation = lose_device = -1;
    met = 0;
  }
  // True once, for the reservation that the count reaches.
  static bool refuses() {
    if (refuse_reservation < 0 || refuse_reservation-- != 0) return false;
    ++met;
    return true;
  }
  // True for every call from there on.
  static bool lost() {
    if (lose_device < 0) return false;
    if (lose_device > 0) {
      --lose_device;
      return false;
    }
    ++met;
    return true;
  }
};

}  // namespace alphascope::gpu
