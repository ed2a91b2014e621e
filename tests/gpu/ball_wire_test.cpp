// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the packed form in which balls are sent to a device.
#include "gpu/dual_edge/ball_wire.cuh"
#include "core/geometry/lattice_point.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <random>

namespace alphascope::gpu {
namespace {

const std::vector<bool> kNoneHidden;

struct Box {
  LatticePoint low, high;
};
constexpr Box kWhole{{INT_MIN, INT_MIN, INT_MIN}, {INT_MAX, INT_MAX, INT_MAX}};

// Random balls between two corners.
class RandomSet {
 public:
  BallSet set;
  void add(std::size_t balls, const Box& box, int radii) {
    for (std::size_t b = 0; b < balls; ++b) {
      set.centres.push_back(
          {any(box.low.x, box.high.x), any(box.low.y, box.high.y), any(box.low.z, box.high.z)});
      set.radii.push_back(1000 + any(0, radii - 1) * 1013);
    }
  }

 private:
  std::int32_t any(std::int32_t from, std::int32_t to) {
    return std::uniform_int_distribution<std::int32_t>(from, to)(random_);
  }
  std::mt19937 random_{4};
};

// Checks that the balls arrive unchanged. Returns the number of words on the wire.
std::size_t expect_to_arrive(const BallSet& set, const std::vector<bool>& hidden = kNoneHidden) {
  const ShownBalls sent{set, hidden};
  const BallPacker packer(sent);
  std::vector<std::uint32_t> wire(packer.layout().words, 0xa5a5a5a5u);
  packer.pack(wire.data());
  const PackedBalls arrived{wire.data(), packer.layout()};
  for (BallIndex i = 0; i < set.size(); ++i) {
    const int4 a = sent[i], b = arrived[i];
    if (a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w) continue;
    ADD_FAILURE() << "ball " << i << " of " << set.size() << " is another: " << b.x << ' ' << b.y
                  << ' ' << b.z << ' ' << b.w;
    break;
  }
  return wire.size();
}

TEST(BallWire, BringsBallsUnchanged) {
  const Box boxes[] = {{{5, 5, 5}, {5, 5, 5}},
                       {{0, -1, -3}, {0, 0, 4}},
                       {{-123456, 7, -1}, {800000, 524294, 1048574}},
                       {{INT_MIN, 0, INT_MAX - 3}, {INT_MAX, 9, INT_MAX}},
                       kWhole};
  for (const Box& box : boxes) {
    for (const std::size_t balls : {0u, 1u, 31u, 32u, 33u, 1000u, 4096u, 9001u}) {
      for (const int radii : {1, 2, 7, 300}) {
        RandomSet random;
        random.add(balls, box, radii);
        expect_to_arrive(random.set);
      }
    }
  }
}

TEST(BallWire, GivesEveryGroupItsOwnWidths) {
  RandomSet random;
  const std::size_t groups = 300;
  for (std::size_t g = 0; g < groups; ++g) {
    const std::int32_t at = static_cast<std::int32_t>(g) * 7000000;
    random.add(kWireGroup, {{at, -at, 0}, {at + 15, 15 - at, 15}}, 2);
  }
  const std::size_t narrow = expect_to_arrive(random.set);
  // 3 * 4 bits and those of the radius are 13 words a group, 17 with the head.
  EXPECT_EQ(narrow, groups * 17 + 3 + 2 + 2);
  random.add(10, kWhole, 2);
  random.add(kWireGroup, {{0, 0, 0}, {15, 15, 15}}, 2);
  EXPECT_LT(expect_to_arrive(random.set), narrow + 2 * (4 + 97));
}

TEST(BallWire, TellsTheDeviceWhichBallsAreHidden) {
  RandomSet random;
  random.add(100, {{0, 0, 0}, {9, 9, 9}}, 3);
  std::vector<bool> hidden(100);
  hidden[0] = hidden[40] = hidden[99] = true;
  expect_to_arrive(random.set, hidden);
  EXPECT_EQ((ShownBalls{random.set, hidden}[40].w), -1);
  EXPECT_EQ((ShownBalls{random.set, hidden}[41].w), random.set.radii[41]);
}

// A chain of atoms 1.5 Å apart in a sphere of 150 Å. The unit is 10^-3 Å.
BallSet folded_chain(int atoms) {
  BallSet set;
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  double at[3] = {0, 0, 0};
  for (int a = 0; a < atoms; ++a) {
    double step[3], length = 0, inward = 0;
    for (double& s : step) s = any(random);
    for (int k = 0; k < 3; ++k) length += step[k] * step[k], inward += at[k] * at[k];
    for (int k = 0; k < 3; ++k) {
      at[k] += 1500 * step[k] / std::sqrt(length) - (inward > 150000.0 * 150000.0 ? at[k] / 50 : 0);
    }
    set.centres.push_back({static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1]),
                           static_cast<std::int32_t>(at[2])});
    set.radii.push_back(a % 4 == 3 ? 1348 : a % 4 == 0 ? 1400 : 1548);
  }
  return set;
}

TEST(BallWire, BringsAChainInSixBytesABall) {
  const BallSet set = folded_chain(100000);
  EXPECT_TRUE((BallPacker({set, kNoneHidden}).pays()));
  EXPECT_LT(4.0 * static_cast<double>(expect_to_arrive(set)), 6.0 * 100000);
}

TEST(BallWire, LeavesBallsAsTheyAreWherePackingDoesNotPay) {
  RandomSet random;
  EXPECT_FALSE((BallPacker({random.set, kNoneHidden}).pays()));
  random.add(1, kWhole, 1);
  EXPECT_FALSE((BallPacker({random.set, kNoneHidden}).pays()));
  random.add(999, kWhole, 1);
  EXPECT_TRUE((BallPacker({random.set, kNoneHidden}).pays()));
}

// Gives the balls `radii` different radii.
BallSet with_radii(std::int32_t radii) {
  RandomSet random;
  random.add(30000, {{0, 0, 0}, {1000, 1000, 1000}}, 1);
  for (std::int32_t i = 0; i < 30000; ++i) random.set.radii[i] = 1 + i % radii * 64;
  return random.set;
}

TEST(BallWire, TakesManyRadiiButNoLongTable) {
  const BallSet many = with_radii(4096), too_many = with_radii(4097);
  EXPECT_TRUE((BallPacker({many, kNoneHidden}).pays()));
  expect_to_arrive(many);
  EXPECT_FALSE((BallPacker({too_many, kNoneHidden}).pays()));
}

}  // namespace
}  // namespace alphascope::gpu
