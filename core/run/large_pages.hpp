// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for large arrays. The system provides a page at its first write. For an array of a hundred
// megabytes that takes longer than filling it; with large pages there are few such steps.
#pragma once

#include <cstddef>

namespace alphascope {

// Smaller arrays use the usual allocator.
inline constexpr std::size_t kLargeArrayBytes = std::size_t{8} << 20;

// Memory that is not initialised, on large pages where the system offers them on request. Throws
// std::bad_alloc.
void* allocate_large(std::size_t bytes);
void free_large(void* memory) noexcept;

}  // namespace alphascope
