// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the sieve with the scalar cuts, for each kind of processor that this machine can run.
#include "core/dual_edge/cut_sieve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tests/support/for_processors.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::for_processors;
using testing::random_int;
using Takes = DualEdge<double>::Takes;

// Lifted vectors of balls of radius 0 around the first one, and beyond them numbers that must not
// be looked at.
LiftedColumns random_columns(testing::Random& random, int count, int extent) {
  LiftedColumns columns;
  columns.resize(static_cast<std::size_t>(count));
  const auto coordinate = [&] { return static_cast<double>(random_int(random, -extent, extent)); };
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    columns.set(k, {x, y, z, x * x + y * y + z * z + coordinate()});
  }
  for (std::size_t k = 0; k < LiftedColumns::kRoom; ++k) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    columns.set(static_cast<std::size_t>(count) + k, {kNone, kNone, kNone, kNone});
  }
  return columns;
}

struct Sieved {
  bool all = false;  // a ball cuts off all of the edge
  std::vector<std::uint32_t> some;
  friend bool operator==(const Sieved& a, const Sieved& b) {
    return a.all == b.all && (a.all || a.some == b.some);
  }
};

Sieved expected(const DualEdge<double>& edge, const LiftedColumns& columns,
                const std::vector<std::uint32_t>& asked) {
  Sieved sieved;
  sieved.some.assign(asked.size(), 0);
  for (std::size_t k = 0; k < 32 * asked.size(); ++k) {
    if ((asked[k / 32] >> k % 32 & 1) == 0) continue;
    const Takes takes = edge.takes(edge.cut_by(columns[k]));
    sieved.all = sieved.all || takes == Takes::all;
    if (takes == Takes::some) sieved.some[k / 32] |= std::uint32_t{1} << k % 32;
  }
  return sieved;
}

Sieved sieved_by_vectors(const DualEdge<double>& edge, const LiftedColumns& columns,
                         std::vector<std::uint32_t> asked) {
  const SievedEdge line{edge.direction(), edge.foot(), edge.slope_error(), edge.offset_error(),
                        edge.reach()};
  const bool all = sieve_cuts(line, columns, asked.data(), static_cast<int>(asked.size()));
  return {all, std::move(asked)};
}

// Balls of which each is asked about or not, by chance.
std::vector<std::uint32_t> random_bits(testing::Random& random, int count) {
  std::vector<std::uint32_t> bits((static_cast<std::size_t>(count) + 31) / 32, 0);
  for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(count); ++k) {
    bits[k / 32] |= static_cast<std::uint32_t>(random_int(random, 0, 1)) << k % 32;
  }
  return bits;
}

TEST(CutSieve, KeepsTheCutsThatTakeSome) {
  testing::Random random(21);
  std::size_t kept = 0, dropped = 0, emptied = 0;
  for_processors([&] {
    for (int round = 0; round < 3000; ++round) {
      const int count = random_int(random, 2, 80), extent = round % 3 == 0 ? 4 : 3000;
      const LiftedColumns columns = random_columns(random, count, extent);
      DualEdge<double> edge;
      if (!edge.start(columns[0], columns[1], 0.3 * extent * extent)) continue;
      const std::vector<std::uint32_t> asked = random_bits(random, count);
      const Sieved by_scalars = expected(edge, columns, asked);
      EXPECT_EQ(sieved_by_vectors(edge, columns, asked), by_scalars);
      emptied += by_scalars.all;
      for (std::size_t w = 0; w < asked.size() && !by_scalars.all; ++w) {
        kept += static_cast<std::size_t>(__builtin_popcount(by_scalars.some[w]));
        dropped += static_cast<std::size_t>(__builtin_popcount(asked[w] & ~by_scalars.some[w]));
      }
    }
  });
  EXPECT_GT(kept, 1000u);
  EXPECT_GT(dropped, 100u);
  EXPECT_GT(emptied, 100u);
}

// One ball at a time whose plane passes the end of the edge, within some roundings.
TEST(CutSieve, DecidesAsTheScalarCodeAtTheBound) {
  testing::Random random(22);
  std::size_t kept = 0, dropped = 0;
  for_processors([&] {
    for (int round = 0; round < 6000; ++round) {
      LiftedColumns columns = random_columns(random, 3, 2000);
      DualEdge<double> edge;
      if (!edge.start(columns[0], columns[1], 3e6)) continue;
      LiftedVector<double> ball = columns[2];
      // The cut is at the reach where c / 2 - d·foot = |slope| reach.
      const auto cut = edge.cut_by(ball);
      const double farthest = (std::fabs(cut.slope) + cut.slope_error) * edge.reach();
      ball.c += 2 * (farthest + cut.offset_error - cut.offset);
      for (int step = random_int(random, -3, 3); step != 0; step += step < 0 ? 1 : -1) {
        ball.c = std::nextafter(ball.c, step < 0 ? -1e30 : 1e30);
      }
      columns.set(2, ball);
      const Sieved by_scalars = expected(edge, columns, {4});
      EXPECT_EQ(sieved_by_vectors(edge, columns, {4}), by_scalars);
      ++(by_scalars.some[0] != 0 ? kept : dropped);
    }
  });
  EXPECT_GT(kept, 1000u);
  EXPECT_GT(dropped, 1000u);
}

}  // namespace
}  // namespace alphascope
