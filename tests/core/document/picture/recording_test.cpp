// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the frames of recordings, and the names of recordings and files.
#include "core/document/picture/recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "core/document/picture/frame_names.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

Recording sweep(const std::string& text) {
  Recording recording;
  read_sweep(text, recording);
  return recording;
}

Recording turntable(const std::string& text) {
  Recording recording;
  read_turntable(text, recording);
  return recording;
}

template <class Read>
std::string refusal(Read read, const std::string& text) {
  try {
    read(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "(none)";
}

TEST(Recording, ASweepTakesEqualStepsFromOneEndToTheOther) {
  const Recording r = sweep("alpha=-1:10:12");
  EXPECT_EQ(frame_count(r), 12);
  for (int k = 0; k < 12; ++k) EXPECT_DOUBLE_EQ(alpha_of_frame(r, k), -1 + k) << k;
  EXPECT_EQ(alpha_of_frame(sweep("alpha=2:3:1"), 0), 2) << "one frame is the first";
}

// Engine, caption and file all give the whole number.
TEST(Recording, AlphasOfFramesAreDecimalNumbersNearTheirPlaces) {
  const Recording r = sweep("alpha=-1:10:120");
  std::set<double> seen;
  for (int k = 0; k < 120; ++k) {
    const double alpha = alpha_of_frame(r, k), exact = -1 + 11.0 * k / 119;
    EXPECT_NEAR(alpha, exact, 0.1 * 11.0 / 119) << k;
    EXPECT_DOUBLE_EQ(alpha * 1000, std::round(alpha * 1000)) << k;
    seen.insert(alpha);
  }
  EXPECT_EQ(seen.size(), 120u);
  EXPECT_EQ(*seen.begin(), -1);
  EXPECT_EQ(*seen.rbegin(), 10);
}

TEST(Recording, RootsAndLogarithmsTakeSmallerStepsNearZero) {
  for (const AlphaScaling scaling : {AlphaScaling::root, AlphaScaling::logarithm}) {
    Recording r = sweep("alpha=0:16:5");
    r.scaling = scaling;
    for (int k = 2; k < 5; ++k) {
      EXPECT_GT(alpha_of_frame(r, k) - alpha_of_frame(r, k - 1),
                alpha_of_frame(r, k - 1) - alpha_of_frame(r, k - 2));
    }
    EXPECT_EQ(alpha_of_frame(r, 0), 0);
    EXPECT_EQ(alpha_of_frame(r, 4), 16);
  }
  Recording roots = sweep("alpha=-4:4:5");
  roots.scaling = AlphaScaling::root;
  EXPECT_EQ(alpha_of_frame(roots, 1), -1);
  EXPECT_EQ(alpha_of_frame(roots, 2), 0);
  EXPECT_EQ(alpha_of_frame(roots, 3), 1);
}

TEST(Recording, ThereAndBackRepeatsNeitherEnd) {
  Recording r = sweep("alpha=0:3:4");
  r.there_and_back = true;
  ASSERT_EQ(frame_count(r), 6);
  const double expected[] = {0, 1, 2, 3, 2, 1};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(alpha_of_frame(r, k), expected[k]) << k;
  r.frames = 1;
  EXPECT_EQ(frame_count(r), 1);
}

TEST(Recording, WholeTurnsCloseAndOthersReachTheirEnd) {
  const Recording whole = turntable("360:4");
  for (int k = 0; k < 4; ++k) EXPECT_EQ(degrees_of_frame(whole, k), 90 * k);
  const Recording part = turntable("-90:4");
  EXPECT_EQ(degrees_of_frame(part, 0), 0);
  EXPECT_EQ(degrees_of_frame(part, 3), -90);
  Recording back = turntable("360:3");
  back.there_and_back = true;
  ASSERT_EQ(frame_count(back), 4);
  EXPECT_EQ(degrees_of_frame(back, 2), 360);
  EXPECT_EQ(degrees_of_frame(back, 3), 180);
  EXPECT_EQ(degrees_of_frame(turntable("180:1"), 0), 0);
}

TEST(Recording, WhatCannotBeIsExplained) {
  const auto read = [](const std::string& text) { sweep(text); };
  EXPECT_NE(refusal(read, "alpha=10:-1:120").find("from -1 to 10 Å² instead"), std::string::npos)
      << refusal(read, "alpha=10:-1:120");
  EXPECT_NE(refusal(read, "alpha=1:1:120").find("not from 1 to 1 Å²"), std::string::npos)
      << refusal(read, "alpha=1:1:120");
  for (const char* text : {"alpha=1:2", "solvent=1:2:3", "alpha=1:2:3:4", ""}) {
    EXPECT_NE(refusal(read, text).find("such as alpha=-1:10:120"), std::string::npos) << text;
  }
  for (const char* text : {"alpha=1:2:0", "alpha=1:2:1000000", "alpha=1:2:-5", "alpha=1:2:2.5"}) {
    EXPECT_NE(refusal(read, text).find("whole number from 1 to 20000"), std::string::npos) << text;
  }
  for (const char* text :
       {"alpha=x:2:3", "alpha=nan:2:3", "alpha=1:inf:3", "alpha=1:2:", "alpha=:2:3"}) {
    EXPECT_NE(refusal(read, text).find("is not a number"), std::string::npos) << text;
  }
  EXPECT_NE(refusal(read, "alpha=1:1e300:3").find("Alpha must be from"), std::string::npos);
  const auto turn = [](const std::string& text) { turntable(text); };
  EXPECT_NE(refusal(turn, "360").find("such as 360:120"), std::string::npos);
  EXPECT_NE(refusal(turn, "0:10").find("not 0"), std::string::npos);
  EXPECT_NE(refusal(turn, "1e9:10").find("The turn must be from"), std::string::npos);
  Recording fast;
  fast.frames_per_second = 0;
  EXPECT_NE(fault_of(fast).find("frame rate"), std::string::npos);
  EXPECT_EQ(fault_of(Recording()), "");
}

TEST(Recording, PointsTurnAboutAxesRightHandedAndKeepTheirDistance) {
  const auto p = turned({3, 0, 5}, {1, 0, 5}, {0, 1, 0}, 90);
  EXPECT_NEAR(p[0], 1, 1e-12);
  EXPECT_NEAR(p[1], 0, 1e-12);
  EXPECT_NEAR(p[2], 3, 1e-12);
  const double s = 1 / std::sqrt(3);
  const auto q = turned({1, 0, 0}, {0, 0, 0}, {s, s, s}, 120);
  EXPECT_NEAR(q[0], 0, 1e-12);
  EXPECT_NEAR(q[1], 1, 1e-12);
  EXPECT_NEAR(q[2], 0, 1e-12);
}

TEST(Recording, IdsAreThoseOfTheirLists) {
  for (const TurnAxis axis : {TurnAxis::up, TurnAxis::x, TurnAxis::y, TurnAxis::z}) {
    EXPECT_EQ(turn_axis_from_id(turn_axis_id(axis)), axis);
    EXPECT_NE(std::string(kTurnAxes).find(turn_axis_id(axis)), std::string::npos);
  }
  EXPECT_EQ(turn_axis_from_id("y"), TurnAxis::y);
  EXPECT_EQ(scaling_from_id("root"), AlphaScaling::root);
  for (const AlphaScaling s : {AlphaScaling::linear, AlphaScaling::root, AlphaScaling::logarithm}) {
    EXPECT_EQ(scaling_from_id(scaling_id(s)), s);
    EXPECT_NE(std::string(kScalings).find(scaling_id(s)), std::string::npos);
  }
}

TEST(FrameNames, AreNumberedFromThePlaceInTheName) {
  EXPECT_EQ(FrameNames("out/frame-%04d.png").name(7), "out/frame-0007.png");
  EXPECT_EQ(FrameNames("frame-%04d.png").name(12345), "frame-12345.png");
  EXPECT_EQ(FrameNames("%d.png").name(1), "1.png");
  EXPECT_EQ(FrameNames("100%%-%03d.png").name(2), "100%-002.png");
  EXPECT_EQ(FrameNames("50%/f%d.png").name(3), "50%/f3.png") << "a folder's name is as it is";
  for (const char* name : {"frame.png", "a%d-%d.png", "a%s.png", "a%4d.png", "a%.png", "a%",
                           "a%x%d.png", "a%00d.png", "a%012d.png"}) {
    EXPECT_THROW(FrameNames{name}, std::invalid_argument) << name;
  }
}

TEST(FrameNames, TheEndingSaysTheFormat) {
  EXPECT_EQ(recording_format("a%d.PNG"), RecordingFormat::frames);
  EXPECT_EQ(recording_format("a.mp4"), RecordingFormat::mp4);
  EXPECT_EQ(recording_format("a.webm"), RecordingFormat::webm);
  EXPECT_THROW(recording_format("a.avi"), std::invalid_argument);
  EXPECT_THROW(recording_format("a"), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
