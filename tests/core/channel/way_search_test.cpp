// SPDX-License-Identifier: GPL-3.0-or-later
// Tests searches along an axis against the definition: Dijkstra's search inwards from both sides.
#include "core/channel/way_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "core/channel/envelope.hpp"
#include "core/geometry/ball_set.hpp"
#include "tests/core/cavity/rings.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::no_balls;
using testing::Random;
using testing::random_int;

constexpr int kNoLabel = 0;

// The steps that a way along the axis may take.
class AxisSteps {
 public:
  AxisSteps(const WayGraph& graph, const WayAxis& axis) : graph_(graph), axis_(axis) {}
  bool leads(std::uint32_t from, std::size_t k) const {
    const std::uint32_t to = graph_.links(from)[k].to;
    if (to == WayGraph::kNothing || !is_free(to)) return false;
    return axis_.stays_near_axis(graph_.corner(from), graph_.corner(to));
  }

 private:
  bool is_free(std::uint32_t t) const {
    const RealPoint& corner = graph_.corner(t);
    return graph_.is_outside(t) || axis_.zone(corner) != 0 || axis_.is_near(corner);
  }

  const WayGraph& graph_;
  const WayAxis& axis_;
};

// For each tetrahedron the side from which the larger sphere reaches it.
std::vector<int> labels_of(const WayGraph& graph, const WayAxis& axis) {
  using Entry = std::pair<float, std::uint32_t>;
  const AxisSteps steps(graph, axis);
  std::priority_queue<Entry> open;
  std::vector<float> widest(graph.size(), -1);
  std::vector<int> label(graph.size(), kNoLabel);
  for (std::uint32_t t = 0; t < graph.size(); ++t) {
    if (!graph.is_outside(t)) continue;
    label[t] = axis.side(graph.corner(t));
    widest[t] = std::numeric_limits<float>::infinity();
    open.push({widest[t], t});
  }
  while (!open.empty()) {
    const auto [own, t] = open.top();
    open.pop();
    if (own < widest[t]) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!steps.leads(t, k)) continue;
      const WayGraph::Link& link = graph.links(t)[k];
      const float next = std::min(own, link.power);
      if (next <= widest[link.to]) continue;
      widest[link.to] = next;
      label[link.to] = label[t];
      open.push({next, link.to});
    }
  }
  return label;
}

// Of all rings where both labels meet, the widest ones that are not beside each other.
std::vector<WayCrossing> crossings_of(const WayGraph& graph, const WayAxis& axis) {
  const std::vector<int> label = labels_of(graph, axis);
  const AxisSteps steps(graph, axis);
  std::vector<WayCrossing> all, result;
  for (const WayRing& ring : graph.rings()) {
    const WayFace& face = graph.faces()[ring.face];
    if (label[face.a] == kNoLabel || label[face.a] != -label[face.b]) continue;
    WayCrossing crossing;
    crossing.below = label[face.a] < 0 ? face.a : face.b;
    crossing.above = label[face.a] < 0 ? face.b : face.a;
    crossing.width_angstrom = ring.clearance_angstrom;
    const std::size_t k = graph.link_to(crossing.below, crossing.above);
    if (!steps.leads(crossing.below, k)) continue;
    crossing.place_angstrom = graph.gap_at(crossing.below, k).place_angstrom;
    all.push_back(crossing);
  }
  std::sort(all.begin(), all.end(), [](const WayCrossing& a, const WayCrossing& b) {
    if (a.width_angstrom != b.width_angstrom) return a.width_angstrom > b.width_angstrom;
    return a.below < b.below;
  });
  for (const WayCrossing& crossing : all) {
    const auto is_beside = [&](const WayCrossing& other) { return are_beside(other, crossing); };
    if (std::none_of(result.begin(), result.end(), is_beside)) result.push_back(crossing);
  }
  return result;
}

void expect_first(const std::vector<WayCrossing>& found, const std::vector<WayCrossing>& expected,
                  std::size_t count) {
  ASSERT_EQ(found.size(), count);
  for (std::size_t n = 0; n < count; ++n) {
    EXPECT_EQ(found[n].below, expected[n].below) << n;
    EXPECT_EQ(found[n].above, expected[n].above) << n;
    EXPECT_EQ(found[n].width_angstrom, expected[n].width_angstrom) << n;
  }
}

// A block of loose balls of different sizes, with holes.
BallSet loose_block(Random& random, int count) {
  BallSet balls = no_balls();
  const double larger = std::cbrt(std::max(1.0, count / 400.0));
  const int width = static_cast<int>(12000 * larger), height = static_cast<int>(16000 * larger);
  for (int n = 0; n < count; ++n) {
    add_ball(balls, random_int(random, -width, width), random_int(random, -width, width),
             random_int(random, -height, height), random_int(random, 1000, 2300));
  }
  return balls;
}

TEST(WaySearch, FindsTheCrossingsOfDijkstrasSearch) {
  Random random(21);
  std::size_t seen = 0;
  for (const int count : {60, 200, 350, 500, 3000}) {
    const BallSet balls = loose_block(random, count);
    const Envelope envelope(balls);
    const WayGraph graph(balls, envelope, {});
    std::vector<BallIndex> part(balls.size());
    std::iota(part.begin(), part.end(), BallIndex{0});
    for (const RealPoint& along :
         {RealPoint{0, 0, 1}, RealPoint{1, 0, 0}, RealPoint{0.6, 0.8, 0}}) {
      SCOPED_TRACE(count);
      const WayAxis axis(balls, part, along);
      const std::vector<WayCrossing> expected = crossings_of(graph, axis);
      seen += expected.size();
      // All of them, then the widest few, then those of some width.
      expect_first(WaySearch(graph, axis, 100000, 0, {}).crossings(), expected, expected.size());
      for (const std::size_t most : {1, 2, 5}) {
        expect_first(WaySearch(graph, axis, most, 0, {}).crossings(), expected,
                     std::min(most, expected.size()));
      }
      if (expected.size() < 2) continue;
      const double least = expected[expected.size() / 2].width_angstrom;
      const std::vector<WayCrossing> wide = WaySearch(graph, axis, 100000, least, {}).crossings();
      const auto is_wide = [&](const WayCrossing& c) { return c.width_angstrom >= least; };
      expect_first(
          wide, expected,
          static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), is_wide)));
    }
  }
  EXPECT_GT(seen, 40u);
}

TEST(WaySearch, ARouteIsNowhereNarrowerByPowerThanItsCrossing) {
  Random random(22);
  const BallSet balls = loose_block(random, 350);
  const Envelope envelope(balls);
  const WayGraph graph(balls, envelope, {});
  std::vector<BallIndex> part(balls.size());
  std::iota(part.begin(), part.end(), BallIndex{0});
  const WayAxis axis(balls, part, {0, 0, 1});
  const AxisSteps steps(graph, axis);
  WaySearch search(graph, axis, 8, 0, {});
  ASSERT_FALSE(search.crossings().empty());
  for (const WayCrossing& crossing : search.crossings()) {
    const WayRoute route = search.route(crossing, {});
    EXPECT_LE(route.width_angstrom, crossing.width_angstrom);
    for (const auto* side : {&route.below, &route.above}) {
      ASSERT_FALSE(side->empty());
      EXPECT_EQ(side->front(), side == &route.below ? crossing.below : crossing.above);
      for (std::size_t n = 0; n < side->size(); ++n) {
        EXPECT_EQ(graph.is_outside((*side)[n]), n + 1 == side->size());
        if (n + 1 == side->size()) break;
        const std::size_t k = graph.link_to((*side)[n], (*side)[n + 1]);
        EXPECT_TRUE(steps.leads((*side)[n], k));
        EXPECT_GE(graph.links((*side)[n])[k].power, crossing.power);
        EXPECT_GE(graph.links((*side)[n])[k].gap_angstrom + 1e-5, route.width_angstrom);
      }
    }
    EXPECT_EQ(axis.side(graph.corner(route.below.back())), -1);
    EXPECT_EQ(axis.side(graph.corner(route.above.back())), 1);
    // A second answer is the same.
    const WayRoute again = search.route(crossing, {});
    EXPECT_EQ(again.below, route.below);
    EXPECT_EQ(again.above, route.above);
  }
}

}  // namespace
}  // namespace alphascope
