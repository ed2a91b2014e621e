// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that slabs give the result of the whole set for all cuts. Simplices, values and classes are
// the same, in the same order.
#include "core/engine/slabs.hpp"

#include <gtest/gtest.h>

#include "core/geometry/alpha.hpp"
#include "core/run/cancel_token.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::expect_same;
using testing::NamedBalls;
using testing::Random;

AlphaComplex in_slabs(const BallSet& balls, const AlphaRequest& request, std::size_t slabs) {
  return compute_in_slabs(balls, request, slabs, {}, [&](std::shared_ptr<const BallSet> part) {
    return make_cpu_engine(std::move(part), {1})->compute(request, {});
  });
}

TEST(Slabs, GiveTheWholeComplex) {
  Random random(21);
  for (const NamedBalls& set :
       testing::large_hard_sets(random, testing::unless_sanitized(1000, 60))) {
    SCOPED_TRACE(set.name);
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const double unit = set.alpha_unit();
    for (const double alpha : {-1.0, 0.0, 0.5, 3.0}) {
      for (const bool tetrahedra_only : {false, true}) {
        const AlphaRequest request{alpha * unit, tetrahedra_only};
        const AlphaComplex whole = make_cpu_engine(balls, {1})->compute(request, {});
        for (const std::size_t slabs : {1, 2, 3, 7}) {
          SCOPED_TRACE(std::to_string(slabs) + " slabs, alpha " + std::to_string(alpha));
          const AlphaComplex found = in_slabs(*balls, request, slabs);
          expect_same(found, whole);
        }
      }
    }
  }
}

TEST(Slabs, HoldFewerBallsEach) {
  BallSet row;
  for (int i = 0; i < 1000; ++i) {
    row.centres.push_back({(i * 389 % 1000) * 100, 0, i % 7});
    row.radii.push_back(120);
  }
  std::size_t parts = 0, most = 0;
  compute_in_slabs(row, {0, true}, 10, {}, [&](std::shared_ptr<const BallSet> part) {
    ++parts;
    most = std::max(most, part->size());
    return make_cpu_engine(std::move(part))->compute({0, true}, {});
  });
  EXPECT_EQ(parts, 10u);
  EXPECT_LE(most, 110u);
}

// Coordinates x are symmetric about zero, and all y are far from zero.
TEST(Slabs, AreCutAcrossTheLongestSideWhereverItLies) {
  BallSet row;
  for (int i = 0; i < 40; ++i) {
    row.centres.push_back({(i * 17 % 40) * 1000 - 20'000, 100'000 + i % 3, 0});
    row.radii.push_back(1);
  }
  std::vector<std::size_t> sizes;
  compute_in_slabs(row, {0, true}, 40, {}, [&](std::shared_ptr<const BallSet> part) {
    sizes.push_back(part->size());
    return AlphaComplex{};
  });
  std::vector<std::size_t> one_and_the_next(40, 2);
  one_and_the_next.back() = 1;
  EXPECT_EQ(sizes, one_and_the_next);
}

TEST(Slabs, SayWhatTheirPartsTook) {
  BallSet row;
  for (int i = 0; i < 30; ++i) {
    row.centres.push_back({i * 1000, 0, 0});
    row.radii.push_back(1);
  }
  int parts = 0;
  const AlphaComplex found =
      compute_in_slabs(row, {0, true}, 3, {}, [&](std::shared_ptr<const BallSet>) {
        AlphaComplex part;
        part.engine.name = "part " + std::to_string(++parts);
        part.engine.rests_on_cgal = parts == 2;  // neither the first part nor the last
        part.timings.stages = {{"upload", 10.0 * parts, true}, {"tuples", 1.0 * parts, false}};
        return part;
      });
  EXPECT_EQ(found.engine.name, "part 3");
  EXPECT_TRUE(found.engine.rests_on_cgal) << "a part did";
  const auto milliseconds = [&](const std::string& label) {
    double sum = 0;
    for (const StageTime& stage : found.timings.stages) {
      if (stage.label == label) sum += stage.milliseconds;
    }
    return sum;
  };
  EXPECT_EQ(milliseconds("upload"), 60);
  EXPECT_EQ(milliseconds("tuples"), 6);
}

TEST(Slabs, OfBallsInOnePlaceAreOne) {
  BallSet balls;
  for (int i = 0; i < 20; ++i) {
    balls.centres.push_back({5, 5, 5});
    balls.radii.push_back(10 + i % 3);
  }
  EXPECT_EQ(in_slabs(balls, {0, false}, 8).vertices.size(), 1u);
  EXPECT_EQ(in_slabs(BallSet{}, {0, false}, 8).vertices.size(), 0u);
}

TEST(Slabs, CanBeCancelledBetween) {
  BallSet row;
  for (int i = 0; i < 100; ++i) {
    row.centres.push_back({i * 100, 0, 0});
    row.radii.push_back(120);
  }
  RunContext context;
  int parts = 0;
  EXPECT_THROW(compute_in_slabs(row, {0, true}, 5, context,
                                [&](std::shared_ptr<const BallSet> part) {
                                  if (++parts == 2) context.cancel.cancel();
                                  return make_cpu_engine(std::move(part))->compute({0, true}, {});
                                }),
               Cancelled);
  EXPECT_EQ(parts, 2);
}

}  // namespace
}  // namespace alphascope
