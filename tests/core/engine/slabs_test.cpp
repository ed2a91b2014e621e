// Slab by slab must give what the whole set gives: the same simplices, values and classes in the
// same order, wherever the cuts fall.
#include "core/engine/slabs.hpp"

#include <gtest/gtest.h>

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
    return make_cpu_engine(std::move(part), {1, false})->compute(request, {});
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
        const AlphaComplex whole = make_cpu_engine(balls, {1, false})->compute(request, {});
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
