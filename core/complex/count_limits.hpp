// SPDX-License-Identifier: GPL-3.0-or-later
// Limits on the numbers of balls and simplices, which the program's 32-bit indices set. A larger
// number is an error with a message before any index wraps around. Each function takes counts, so a
// test needs no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace alphascope {

inline constexpr std::uint64_t kMostIndices = std::numeric_limits<std::uint32_t>::max();

// Throws std::length_error if `count` is above `most`; `what` names the things that are too many.
inline void require_at_most(std::uint64_t count, std::uint64_t most, const char* what) {
  if (count <= most) return;
  throw std::length_error("too many " + std::string(what) + ": " + std::to_string(count) +
                          ", and this program can handle " + std::to_string(most) +
                          ". Choose a smaller alpha, or a part of the molecule.");
}

// The largest number of balls in one set. Indices of grid cells set it: grids on the CPU have up to
// four cells for each ball and a few more. Some code also uses two bits of an index as flags.
inline constexpr std::uint64_t kMostBalls = (std::uint64_t{1} << 30) - 1024;
inline void require_balls(std::uint64_t balls) {
  if (balls <= kMostBalls) return;
  throw std::length_error("too many balls: " + std::to_string(balls) +
                          ", and this program can handle " + std::to_string(kMostBalls) +
                          ". Choose a part of the molecule.");
}

// Requires that indices and sums of all faces of a list of simplices fit, with `faces` faces for
// each simplex (face_groups.hpp).
inline void require_face_records(std::uint64_t simplices, int faces) {
  require_at_most(simplices, kMostIndices / static_cast<std::uint64_t>(faces), "simplices");
}

}  // namespace alphascope
