// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that counts beyond 32 bits are refused with a message, and counts within are accepted.
#include "core/complex/count_limits.hpp"

#include <gtest/gtest.h>

#include <string>

namespace alphascope {
namespace {

std::string refusal(std::uint64_t count, std::uint64_t most) {
  try {
    require_at_most(count, most, "triangles");
  } catch (const std::length_error& error) {
    return error.what();
  }
  return "";
}

TEST(CountLimits, AreTheLastCountsThatFit) {
  EXPECT_EQ(refusal(5, 5), "");
  const std::string said = refusal(6, 5);
  EXPECT_NE(said.find("too many triangles: 6"), std::string::npos) << said;
  EXPECT_NE(said.find("Choose a smaller alpha"), std::string::npos) << said;
}

TEST(CountLimits, CellsOfAGridAreNumberedIn32Bits) {
  EXPECT_NO_THROW(require_balls(kMostBalls));
  EXPECT_THROW(require_balls(kMostBalls + 1), std::length_error);
  EXPECT_LE(4 * kMostBalls + 64, kMostIndices);
}

TEST(CountLimits, FacesOfTetrahedraAreNumberedIn32Bits) {
  constexpr std::uint64_t kMost = (std::uint64_t{1} << 30) - 1;  // each has 4 faces
  EXPECT_NO_THROW(require_face_records(kMost, 4));
  EXPECT_THROW(require_face_records(kMost + 1, 4), std::length_error);
  EXPECT_NO_THROW(require_face_records(kMostIndices, 1));
  EXPECT_THROW(require_face_records(kMostIndices + 1, 1), std::length_error);
}

}  // namespace
}  // namespace alphascope
