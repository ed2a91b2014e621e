// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the clip: its text, the half it keeps, and its rotation.
#include "core/document/settings/clip.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

bool keeps(const Clip& clip, const Vector& x) {
  for (const HalfSpace& space : kept_half_spaces(clip)) {
    if (space.depth(x) < 0) return false;
  }
  return true;
}

Clip read(const std::string& text) {
  const ClipWords words = read_clip(text);
  EXPECT_EQ(words.error, "") << text;
  return words.resolved({0, 0, 1}, {1, 2, 3});
}

TEST(ClipText, NamesAPlaneOrASlab) {
  EXPECT_FALSE(read("off").on());
  const Clip x = read("x=12.5");
  EXPECT_EQ(x.kind, Clip::Kind::plane);
  EXPECT_EQ(x.normal, (Vector{1, 0, 0}));
  EXPECT_EQ(x.position, 12.5);
  EXPECT_TRUE(keeps(x, {12, 0, 0}));
  EXPECT_FALSE(keeps(x, {13, 0, 0}));
  const Clip flipped = read("-y=3");
  EXPECT_FALSE(keeps(flipped, {0, 2, 0}));
  EXPECT_TRUE(keeps(flipped, {0, 4, 0}));
  const Clip slab = read("z=-2:8");
  EXPECT_EQ(slab.kind, Clip::Kind::slab);
  for (const auto& [z, kept] : {std::pair(-6.1, false), {-5.9, true}, {1.9, true}, {2.1, false}}) {
    EXPECT_EQ(keeps(slab, {0, 0, z}), kept) << z;
  }
  const Clip oblique = read("3,0,-4=5");
  EXPECT_DOUBLE_EQ(oblique.normal[0], 0.6);
  EXPECT_DOUBLE_EQ(oblique.normal[2], -0.8);
}

TEST(ClipText, LeavesPositionAndDirectionToWhoeverKnowsThem) {
  EXPECT_EQ(read("y").position, 2);  // through the middle
  const Clip view = read("view:4");
  EXPECT_EQ(view.normal, (Vector{0, 0, 1}));
  EXPECT_EQ(view.position, 3);
  EXPECT_EQ(view.thickness, 4);
}

TEST(ClipText, RefusesWhatItDoesNotUnderstand) {
  for (const char* text : {"", "w", "x=", "x=abc", "1,2", "1,2,3,4=0", "0,0,0", "x=1:0",
                           "x:", "x=1:-3", "x=1e300", "--x"}) {
    EXPECT_NE(read_clip(text).error, "") << text;
  }
  EXPECT_NE(read_clip("w").error.find("x, y=12.5"), std::string::npos);
}

TEST(ClipText, IsReadAsItWasWritten) {
  for (const char* text : {"off", "x=12.5", "-z=-3.25", "y=0:8", "x=1.5:0.1"}) {
    EXPECT_EQ(clip_text(read(text)), text);
  }
  Clip oblique{Clip::Kind::plane, {}, 7.25, 10, true};
  oblique = turned(oblique, {1, 2, -3}, {4, 5, 6});
  Clip negative = read("x=4");
  negative.normal = {-1, 0, 0};
  for (const Clip& clip : {oblique, negative}) {
    const Clip again = read(clip_text(clip));
    for (const Vector& x : {Vector{0, 0, 0}, {4, 5, 7}, {-20, 3, 1}, {30, -2, 8}, {4, 5, 5}}) {
      EXPECT_EQ(keeps(again, x), keeps(clip, x)) << clip_text(clip);
    }
  }
}

TEST(Clip, TurnsAboutAPointOfTheCut) {
  const Clip clip = turned(read("x=4"), {0, 3, 4}, {4, 10, 20});
  EXPECT_DOUBLE_EQ(std::hypot(clip.normal[0], clip.normal[1], clip.normal[2]), 1);
  EXPECT_DOUBLE_EQ(clip.position, 0.6 * 10 + 0.8 * 20);
  EXPECT_EQ(turned(clip, {0, 0, 0}, {0, 0, 0}).normal, clip.normal);
}

}  // namespace
}  // namespace alphascope
