// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the surface of a channel as a mesh.
#include "core/channel/channel_tube.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace alphascope {
namespace {

Channel channel_of(const std::vector<std::pair<RealPoint, double>>& samples) {
  Channel channel;
  for (const auto& [place, radius] : samples) channel.samples.push_back({place, radius, 0});
  return channel;
}

// The volume inside a closed mesh with triangles oriented outwards.
double volume(const ChannelTube& tube) {
  double six = 0;
  for (const auto& [a, b, c] : tube.triangles) {
    six += dot(tube.points[a], cross(tube.points[b], tube.points[c]));
  }
  return six / 6;
}

void expect_closed(const ChannelTube& tube) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : tube.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

// 32 corners on a circle of radius 1 span an area of 16 sin(π / 16).
const double kDisc = 16 * std::sin(std::numbers::pi / 16);

TEST(ChannelTube, OfAStraightLineIsACylinder) {
  std::vector<std::pair<RealPoint, double>> samples;
  for (int n = 0; n <= 50; ++n) samples.push_back({{1 + 0.1 * n, 7, -3}, 2});
  const ChannelTube tube = channel_tube(channel_of(samples));
  expect_closed(tube);
  EXPECT_NEAR(volume(tube), 4 * kDisc * 5, 1e-9);
  ASSERT_EQ(tube.radii_angstrom.size(), tube.points.size());
  for (std::size_t n = 0; n < tube.points.size(); ++n) {
    const RealPoint& p = tube.points[n];
    const double off = std::hypot(p.y - 7, p.z + 3);
    EXPECT_TRUE(std::fabs(off - 2) < 1e-12 || off < 1e-12) << "on the surface, or a centre";
    EXPECT_EQ(tube.radii_angstrom[n], 2);
  }
}

// A cone between two samples, of radii 1 and 3.
TEST(ChannelTube, HasTheRadiiOfItsSamples) {
  const ChannelTube tube = channel_tube(channel_of({{{0, 0, 0}, 1}, {{0, 0, 6}, 3}}));
  expect_closed(tube);
  EXPECT_NEAR(volume(tube), kDisc * 6 * (1 + 3 + 9) / 3, 1e-9);
}

// A quarter of a ring. By Pappus its volume is about the length of the line times the disc.
TEST(ChannelTube, TurnsWithItsLineAndNotAboutIt) {
  std::vector<std::pair<RealPoint, double>> samples;
  constexpr int kSteps = 200;
  for (int n = 0; n <= kSteps; ++n) {
    const double angle = std::numbers::pi / 2 * n / kSteps;
    samples.push_back({{10 * std::cos(angle), 10 * std::sin(angle), 0}, 1.5});
  }
  const ChannelTube tube = channel_tube(channel_of(samples));
  expect_closed(tube);
  EXPECT_NEAR(volume(tube), 2.25 * kDisc * 5 * std::numbers::pi, 0.01);
  // Joined corners of neighbouring rings lie beside each other. With 32 corners they are a fifth of
  // a radian apart.
  for (const auto& [a, b, c] : tube.triangles) {
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
      EXPECT_LT(length(tube.points[from] - tube.points[to]), 1.51);
    }
  }
}

TEST(ChannelTube, EndsWhereTheChannelIsClosed) {
  std::vector<std::pair<RealPoint, double>> samples;
  for (int n = 0; n <= 20; ++n) samples.push_back({{0, 0, 1.0 * n}, n == 8 ? -0.5 : 1});
  const ChannelTube tube = channel_tube(channel_of(samples));
  expect_closed(tube);
  EXPECT_NEAR(volume(tube), kDisc * (7 + 11), 1e-9) << "from 0 to 7 and from 9 to 20";
  EXPECT_TRUE(channel_tube(channel_of({{{0, 0, 0}, 1}, {{0, 0, 1}, -1}})).triangles.empty())
      << "one circle alone";
  EXPECT_TRUE(channel_tube(Channel{}).points.empty());
}

}  // namespace
}  // namespace alphascope
