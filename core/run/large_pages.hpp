// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for large arrays. The system provides a page at its first write. For an array of a hundred
// megabytes that takes longer than filling it; with large pages there are few such steps. Freed
// memory is kept for the next array, because each move of a slider makes arrays of about the same
// size.
#pragma once

#include <cstddef>

namespace alphascope {

// Smaller arrays use the usual allocator.
inline constexpr std::size_t kLargeArrayBytes = std::size_t{8} << 20;

// Memory that is not initialised, on large pages where the system offers them on request. It may be
// an eighth larger than asked for. Throws std::bad_alloc.
void* allocate_large(std::size_t bytes);
// `bytes` as in allocate_large(). Keeps up to kMostKeptBytes for later arrays.
void free_large(void* memory, std::size_t bytes) noexcept;

inline constexpr std::size_t kMostKeptBytes = std::size_t{256} << 20;
// Returns the memory that is kept to the system.
void free_kept_large() noexcept;

}  // namespace alphascope
