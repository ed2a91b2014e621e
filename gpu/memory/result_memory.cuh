// Pinned memory that results arrive in and stay in: to copy one into arrays of its own would take
// about as long as its way back. When nothing is left of a result, a later one gets its memory.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "gpu/memory/device_buffer.cuh"

namespace alphascope::gpu {

// Results may outlive the pipeline and be let go of by any thread. That thread, which may be the
// one that draws, never frees memory: it waits for the device. What nobody will use is freed when
// memory is next asked for, by whatever pipeline, or by free_unused().
class ResultMemory : public std::enable_shared_from_this<ResultMemory> {
 public:
  ResultMemory() { idle_.reserve(kMostIdle + 1); }

  struct Taken {
    std::shared_ptr<unsigned char> memory;
    bool grew;  // whether the system was asked for memory, which takes longer than most runs
  };
  // At least so many bytes, the caller's until all copies of the pointer are gone. Throws
  // std::bad_alloc, DeviceError.
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
  // No more will be asked for.
  void close() {
    rest();
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  // No more will be asked for soon: nothing is kept until the next take(), neither what is idle nor
  // what is given back meanwhile. Waits for the device.
  void rest() {
    std::vector<std::unique_ptr<Buffer>> idle;  // freed after the lock
    const std::lock_guard lock(mutex_);
    resting_ = true;
    idle.swap(idle_);
    idle_.reserve(kMostIdle + 1);
  }

  // Is there memory, of any pipeline, that nobody will use?
  static bool is_any_unused() { return unused().any(); }
  // Frees it. Waits for the device.
  static void free_unused() { unused().free(); }

 private:
  using Buffer = PinnedBuffer<unsigned char>;
  // Of all pipelines.
  class Unused {
   public:
    void add(std::unique_ptr<Buffer> buffer) {
      const std::lock_guard lock(mutex_);
      try {
        buffers_.push_back(std::move(buffer));
        any_ = true;
      } catch (const std::bad_alloc&) {
        buffer.reset();  // so it has to be now
      }
    }
    void free() {
      std::vector<std::unique_ptr<Buffer>> buffers;  // as in close()
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
  // The result that is shown and the next one take turns. In a drag there are three: one is shown,
  // one is being drawn and one computed. At rest two of these are idle. Where they are large, only
  // one is kept, and the next drag asks the system for another: 20 to 60 ms, once.
  static constexpr std::size_t kMostIdle = 2;
  static constexpr std::size_t kMostIdleBytes = std::size_t{1} << 28;

  // The smallest one that has room; else the largest, which is to grow; else a new one.
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
