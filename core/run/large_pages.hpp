// Memory for large arrays. The system hands out pages when they are first written, and for an array
// of a hundred megabytes that takes longer than filling it; of large pages it hands out few.
#pragma once

#include <cstddef>

namespace alphascope {

// Below, an array goes where all others go.
inline constexpr std::size_t kLargeArrayBytes = std::size_t{8} << 20;

// Not initialised; on large pages where the system has them for whoever asks. Throws
// std::bad_alloc.
void* allocate_large(std::size_t bytes);
void free_large(void* memory) noexcept;

}  // namespace alphascope
