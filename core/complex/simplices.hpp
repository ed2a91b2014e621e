// SPDX-License-Identifier: GPL-3.0-or-later
// The arrays in which results are stored: without initialisation, with large pages, or in the
// memory of another object.
#pragma once

#include <array>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/geometry/ball_index.hpp"
#include "core/run/large_pages.hpp"

namespace alphascope {

// An allocator for result arrays. Elements that resize() adds are not initialised; the caller fills
// them, with many threads if the array is large. Nearly all of the cost is the first write to each
// page, when the system provides the page. An array can also begin in memory that another object
// made and filled; its copies are ordinary arrays.
template <class T>
class ResultAllocator {
 public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  using is_always_equal = std::false_type;

  ResultAllocator() = default;
  // The first allocation of up to `room` elements returns `at`. `owner` keeps that memory alive as
  // long as it is used.
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
      if (is_large(count)) return free_large(memory, count * sizeof(T));
      return std::allocator<T>().deallocate(memory, count);
    }
    at_ = nullptr;
    owner_.reset();
  }
  // resize() would set initial values by one thread, before all threads write the elements.
  template <class U>
  void construct(U* at) {
    static_assert(std::is_trivially_default_constructible_v<U>);
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
  std::size_t room_ = 0;  // elements at `at_`; 0 once they are allocated
};

template <class T>
using ResultArray = std::vector<T, ResultAllocator<T>>;

// An array over existing elements, without a copy.
template <class T>
ResultArray<T> in_place(const std::shared_ptr<const void>& owner, std::span<T> content) {
  ResultArray<T> array(ResultAllocator<T>(owner, content.data(), content.size()));
  array.resize(content.size());
  return array;
}

// Simplices of N vertices in ascending order.
template <int N>
using Simplices = ResultArray<std::array<BallIndex, N>>;

}  // namespace alphascope
