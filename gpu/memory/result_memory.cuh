// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned memory in which results arrive and stay. Copying a result to other arrays would take about
// as long as its way to the host. When a result is gone, a later one gets its memory.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "gpu/memory/device_buffer.cuh"

namespace alphascope::gpu {

// Results may outlive the pipeline, and any thread may release them. The thread that releases a
// result may be the one that draws. It never frees the memory, because freeing waits for the
// device. Unused memory is freed by the next take() of any pipeline, or by free_unused().
class ResultMemory : public std::enable_shared_from_this<ResultMemory> {
 public:
  ResultMemory() { idle_.reserve(kMostIdle + 1); }

  struct Taken {
    std::shared_ptr<unsigned char> memory;
    bool grew;  // whether the system was asked for memory, which takes longer than most runs
  };
  // Returns at least this many bytes. They belong to the caller until all copies of the pointer are
  // gone. Throws std::bad_alloc and DeviceError.
  Taken take(std::size_t bytes) {
    unused().free();
    std::unique_ptr<Buffer> buffer = idle(bytes);  // ends a rest
    const bool grew = buffer->reserve(bytes);
    Buffer* const lent = buffer.release();
    const auto back = [pool = shared_from_this(), lent](unsigned char*) {
      pool->give_back(std::unique_ptr<Buffer>(lent));
    };
    return {{lent->get(), back}, grew};
  }
  // Must be called when no more memory will be taken.
  void close() {
    release_memory();
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  // Keeps neither the idle memory nor, until the next take(), memory that is returned. Waits for
  // the device.
  void release_memory() {
    std::vector<std::unique_ptr<Buffer>> idle;  // freed after the lock is released
    const std::lock_guard lock(mutex_);
    resting_ = true;
    idle.swap(idle_);
    idle_.reserve(kMostIdle + 1);
  }

  // Returns whether any pipeline has memory that will not be used.
  static bool is_any_unused() { return unused().any(); }
  // Frees it. Waits for the device.
  static void free_unused() { unused().free(); }

 private:
  using Buffer = PinnedBuffer<unsigned char>;
  // Unused memory of all pipelines.
  class Unused {
   public:
    void add(std::unique_ptr<Buffer> buffer) {
      const std::lock_guard lock(mutex_);
      try {
        buffers_.push_back(std::move(buffer));
        any_ = true;
      } catch (const std::bad_alloc&) {
        buffer.reset();  // no room to note it, so it is freed now
      }
    }
    void free() {
      std::vector<std::unique_ptr<Buffer>> buffers;  // freed after the lock is released
      const std::lock_guard lock(mutex_);
      buffers.swap(buffers_);
      any_ = false;
    }
    bool any() const { return any_; }

   private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Buffer>> buffers_;
    std::atomic<bool> any_{false};
  };
  static Unused& unused() {
    static Unused all;
    return all;
  }
  // While a slider is dragged there are three results: one shown, one being drawn and one being
  // computed. At rest the memory of two of them is idle. If it is large, only one piece is kept.
  // The next drag then asks the system for another piece once, which takes 20 to 60 ms.
  static constexpr std::size_t kMostIdle = 2;
  static constexpr std::size_t kMostIdleBytes = std::size_t{1} << 28;

  // The smallest idle buffer with enough room; else the largest, which then grows; else a new one.
  std::unique_ptr<Buffer> idle(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    resting_ = false;
    if (idle_.empty()) return std::make_unique<Buffer>();
    const auto order = [&](const auto& a, const auto& b) {
      const bool enough = a->capacity() >= bytes, other_enough = b->capacity() >= bytes;
      if (enough != other_enough) return enough;
      return enough ? a->capacity() < b->capacity() : a->capacity() > b->capacity();
    };
    const auto best = std::min_element(idle_.begin(), idle_.end(), order);
    std::unique_ptr<Buffer> buffer = std::move(*best);
    idle_.erase(best);
    return buffer;
  }
  void give_back(std::unique_ptr<Buffer> buffer) {
    const std::lock_guard lock(mutex_);
    if (closed_ || resting_) return unused().add(std::move(buffer));
    idle_.push_back(std::move(buffer));
    std::size_t bytes = 0;
    for (const auto& kept : idle_) bytes += kept->capacity();
    if (idle_.size() == 1 || (idle_.size() <= kMostIdle && bytes <= kMostIdleBytes)) return;
    const auto smallest = std::min_element(
        idle_.begin(), idle_.end(),
        [](const auto& a, const auto& b) { return a->capacity() < b->capacity(); });
    unused().add(std::move(*smallest));
    idle_.erase(smallest);
  }

  std::mutex mutex_;
  bool closed_ = false, resting_ = false;
  std::vector<std::unique_ptr<Buffer>> idle_;
};

}  // namespace alphascope::gpu
