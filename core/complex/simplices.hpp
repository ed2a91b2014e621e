// The arrays that results are made of.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

// What resize() adds is not initialised: who resizes an array fills it, and many threads at once
// when it is large. Nearly all of the time that goes is the system handing out pages, which it does
// when they are first written.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitialisedAllocator<U>;
  };
  UninitialisedAllocator() = default;
  template <class U>
  UninitialisedAllocator(const UninitialisedAllocator<U>&) {}

  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using ResultArray = std::vector<T, UninitialisedAllocator<T>>;

// Simplices of N vertices, which ascend.
template <int N>
using Simplices = ResultArray<std::array<BallIndex, N>>;

}  // namespace alphascope
