// The arrays that results are made of.
#pragma once

#include <array>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/run/large_pages.hpp"

namespace alphascope {

// What resize() adds is not initialised: who resizes an array fills it, and many threads at once
// when it is large. Nearly all of the time that goes is the system handing out pages, which it does
// when they are first written. An array can also begin where its content already is, in memory that
// somebody else made; copies of it are ordinary ones.
template <class T>
class ResultAllocator {
 public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  using is_always_equal = std::false_type;

  ResultAllocator() = default;
  // The first allocation of up to `room` is `at`, which `owner` keeps alive as long as it is used.
  ResultAllocator(std::shared_ptr<const void> owner, T* at, std::size_t room)
      : owner_(std::move(owner)), at_(at), room_(room) {}
  ResultAllocator(const ResultAllocator&) = default;
  ResultAllocator& operator=(const ResultAllocator&) = default;
  template <class U>
  ResultAllocator(const ResultAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (count > room_) {
      if (is_large(count)) return static_cast<T*>(allocate_large(count * sizeof(T)));
      return std::allocator<T>().allocate(count);
    }
    room_ = 0;
    return at_;
  }
  void deallocate(T* memory, std::size_t count) {
    if (memory != at_) {
      if (is_large(count)) return free_large(memory);
      return std::allocator<T>().deallocate(memory, count);
    }
    at_ = nullptr;
    owner_.reset();
  }
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  ResultAllocator select_on_container_copy_construction() const { return {}; }
  friend bool operator==(const ResultAllocator& a, const ResultAllocator& b) {
    return a.at_ == b.at_;
  }

 private:
  static bool is_large(std::size_t count) {
    return count >= kLargeArrayBytes / sizeof(T) && count <= std::size_t(-1) / sizeof(T);
  }

  std::shared_ptr<const void> owner_;
  T* at_ = nullptr;
  std::size_t room_ = 0;  // elements at `at_`, until they are allocated
};

template <class T>
using ResultArray = std::vector<T, ResultAllocator<T>>;

// An array of what is there already.
template <class T>
ResultArray<T> in_place(const std::shared_ptr<const void>& owner, std::span<T> content) {
  ResultArray<T> array(ResultAllocator<T>(owner, content.data(), content.size()));
  array.resize(content.size());
  return array;
}

// Simplices of N vertices, which ascend.
template <int N>
using Simplices = ResultArray<std::array<BallIndex, N>>;

}  // namespace alphascope
