// How many balls and simplices the 32-bit indices of the program reach. What would need more is
// refused in words before anything wraps around: each function takes counts, so that a test needs
// no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace alphascope {

inline constexpr std::uint64_t kMostIndices = std::numeric_limits<std::uint32_t>::max();

// Throws std::length_error, which says what is too much, when `count` is above `most`.
inline void require_at_most(std::uint64_t count, std::uint64_t most, const char* what) {
  if (count <= most) return;
  throw std::length_error("too many " + std::string(what) + ": " + std::to_string(count) +
                          ", and this program can handle " + std::to_string(most) +
                          ". Choose a smaller alpha, or a part of the molecule.");
}

// Balls of one set: the grids have up to four cells for each and some more, and two bits of a
// number are marks.
inline constexpr std::uint64_t kMostBalls = (std::uint64_t{1} << 30) - 1024;
inline void require_balls(std::uint64_t balls) {
  if (balls <= kMostBalls) return;
  throw std::length_error("too many balls: " + std::to_string(balls) +
                          ", and this program can handle " + std::to_string(kMostBalls) +
                          ". Choose a part of the molecule.");
}

// Indices and sums of all faces of a list of simplices, `faces` of each (face_groups.hpp).
inline void require_face_records(std::uint64_t simplices, int faces) {
  require_at_most(simplices, kMostIndices / static_cast<std::uint64_t>(faces), "simplices");
}

}  // namespace alphascope
