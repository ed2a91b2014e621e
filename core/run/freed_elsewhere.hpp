// Large objects that are freed on a thread of its own: to give some hundred megabytes back to the
// system takes tens of milliseconds, in which a window must not stand still.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace alphascope {

// Has that thread call `free_it`, soon. Where it cannot be asked for want of memory, the caller's
// own calls it.
void free_elsewhere(void (*free_it)(const void*) noexcept, const void* object) noexcept;

// Returns when all that was given to free_elsewhere() before is freed. For who counts free memory;
// not from a destructor of what is freed there.
void wait_until_freed();

// Like std::make_shared<const T>(std::move(value)); weak pointers expire at once, and the last who
// lets go of it does not wait for the memory.
template <class T>
std::shared_ptr<const T> freed_elsewhere(T value) {
  static_assert(std::is_nothrow_destructible_v<T>);
  const auto free_it = [](const void* object) noexcept { delete static_cast<const T*>(object); };
  return std::shared_ptr<const T>(new T(std::move(value)),
                                  [free_it](const T* object) { free_elsewhere(free_it, object); });
}

}  // namespace alphascope
