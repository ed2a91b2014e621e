// SPDX-License-Identifier: GPL-3.0-or-later
// Frees large objects on a separate thread. Returning some hundred megabytes to the system takes
// tens of milliseconds, and a window must not freeze for so long.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace alphascope {

// Makes that thread call `free_it` soon. If memory is too short for that, the calling thread calls
// it.
void free_on_other_thread(void (*free_it)(const void*) noexcept, const void* object) noexcept;

// Waits until all objects given to free_on_other_thread() before are freed, and frees large arrays
// that were kept for later ones. For code that measures free memory. Do not call it from a
// destructor of such an object.
void wait_until_freed();

// Like std::make_shared<const T>(std::move(value)), but the last owner does not wait for the memory
// to be freed. Weak pointers expire at once.
template <class T>
std::shared_ptr<const T> freed_on_other_thread(T value) {
  static_assert(std::is_nothrow_destructible_v<T>);
  const auto free_it = [](const void* object) noexcept { delete static_cast<const T*>(object); };
  return std::shared_ptr<const T>(new T(std::move(value)), [free_it](const T* object) {
    free_on_other_thread(free_it, object);
  });
}

}  // namespace alphascope
