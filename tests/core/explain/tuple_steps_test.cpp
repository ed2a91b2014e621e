// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the steps of one ball through the tuple engine. Summed over all balls, the numbers are
// those of the engine, with any switches. The result is the star of the ball in CGAL's complex.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "core/engine/engine.hpp"
#include "core/explain/ball_steps.hpp"
#include "core/geometry/alpha.hpp"
#include "core/tuples/tuple_engine.hpp"
#include "tests/core/explain/star_of.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;
namespace id = step_count;

std::vector<TupleOptions> all_optimisations() {
  std::vector<TupleOptions> all;
  for (int bits = 0; bits < 4; ++bits) {
    TupleOptions options;
    options.edge_optimisation = bits & 1;
    options.alpha_optimisation = bits & 2;
    all.push_back(options);
  }
  return all;
}
// Returns all combinations of switches. Those with the thesis' grid, of a million cells, take long
// for each ball.
std::vector<TupleOptions> all_switches() {
  std::vector<TupleOptions> all = all_optimisations();
  for (TupleOptions options : all_optimisations()) {
    options.grid = TupleGridKind::thesis;
    all.push_back(options);
  }
  return all;
}

// Each step begins with the simplices that the last one kept, and every simplex is kept or dropped
// once.
void expect_consistent(const BallSteps& steps) {
  const auto all = [&](StepKind kind, std::string_view what) {
    return steps.find(kind)->count(what).all;
  };
  if (steps.left_out != LeftOutReason::no) {
    EXPECT_EQ(steps.steps.size(), 1u);
    return;
  }
  EXPECT_EQ(all(StepKind::pairs, id::kMade), all(StepKind::cube, id::kNeighbours));
  for (const StepKind kind :
       {StepKind::pairs, StepKind::triples, StepKind::tuples, StepKind::alpha}) {
    EXPECT_EQ(all(kind, id::kMade), all(kind, id::kDropped) + all(kind, id::kKept));
    if (!steps.find(kind)->off) continue;
    EXPECT_EQ(all(kind, id::kDropped), 0u);
  }
  EXPECT_EQ(all(StepKind::alpha, id::kMade), all(StepKind::tuples, id::kKept));
  EXPECT_EQ(all(StepKind::filter, id::kTested), all(StepKind::alpha, id::kKept));
  EXPECT_EQ(all(StepKind::filter, id::kTested),
            all(StepKind::filter, id::kConflict) + all(StepKind::filter, id::kAboveAlpha) +
                all(StepKind::filter, id::kValid) + all(StepKind::filter, id::kBand));
  EXPECT_EQ(all(StepKind::exact, id::kTested), all(StepKind::filter, id::kBand));
  EXPECT_EQ(all(StepKind::exact, id::kTested),
            all(StepKind::exact, id::kConflict) + all(StepKind::exact, id::kAboveAlpha) +
                all(StepKind::exact, id::kFlat) + all(StepKind::exact, id::kValid));
  EXPECT_EQ(all(StepKind::result, id::kTetrahedra),
            all(StepKind::filter, id::kValid) + all(StepKind::exact, id::kValid));
  for (const StepKind kind : {StepKind::filter, StepKind::exact}) {
    std::uint64_t removed = 0, listed = 0;
    for (const StepConflict& remover : steps.find(kind)->removers) removed += remover.simplices;
    EXPECT_EQ(removed, all(kind, id::kConflict));
    for (const MarkedSimplices& m : steps.find(kind)->marks)
      listed += m.tetrahedra.size() + m.left_out;
    EXPECT_EQ(listed, all(kind, id::kTested));
  }
}

// Adds up counts, and tells which of them were not zero. A comparison of zeros would show nothing.
class Sums {
 public:
  void add(const BallSteps& steps) {
    if (steps.left_out != LeftOutReason::no) return;
    const auto here = [&](StepKind kind, std::string_view what) {
      return steps.find(kind)->count(what).here;
    };
    sum_["neighbours in cubes"] += here(StepKind::cube, id::kNeighbours) + earlier(steps);
    sum_["pairs"] += here(StepKind::pairs, id::kKept);
    sum_["triples"] += here(StepKind::triples, id::kKept);
    sum_["4-tuples enumerated"] += here(StepKind::tuples, id::kKept);
    sum_["4-tuples into kernel II"] += here(StepKind::places, id::kKept);
    sum_["4-tuples into kernel III"] += here(StepKind::filter, id::kBand);
    sum_["edges and triangles into kernel III"] += here(StepKind::faces, id::kLowerBand);
    sum_["valid 4-tuples"] +=
        here(StepKind::filter, id::kValid) + here(StepKind::exact, id::kValid);
  }
  void expect(const AlphaComplex& complex) {
    for (const EngineCounter& counter : complex.engine.counters) {
      if (counter.name == "batches") continue;
      EXPECT_EQ(sum_[counter.name], counter.value) << counter.name;
      seen_[counter.name] += counter.value;
    }
    sum_.clear();
  }
  void expect_all_seen() const {
    for (const auto& [name, value] : seen_) EXPECT_GT(value, 0u) << name;
    EXPECT_EQ(seen_.size(), 8u);
  }

 private:
  static std::uint64_t earlier(const BallSteps& steps) {
    const StepCount& found = steps.find(StepKind::cube)->count(id::kNeighbours);
    return found.all - found.here;
  }
  std::map<std::string, std::uint64_t> sum_, seen_;
};

void expect_steps(const BallSet& balls, const std::vector<double>& alphas,
                  const std::vector<TupleOptions>& switches, Sums& sums) {
  const auto shared = std::make_shared<const BallSet>(balls);
  const auto cgal = testing::keeping(make_cgal_engine(shared, {1}));
  for (const double alpha : alphas) {
    const AlphaComplex whole = cgal->compute({alpha}, {});
    for (const TupleOptions& options : switches) {
      SCOPED_TRACE("alpha " + std::to_string(alpha) + ", edges " +
                   std::to_string(options.edge_optimisation) + ", alpha " +
                   std::to_string(options.alpha_optimisation));
      const AlphaComplex tuples = make_tuple_engine(shared, {1}, options)->compute({alpha}, {});
      testing::expect_same(tuples, whole);
      for (BallIndex b = 0; b < balls.size(); ++b) {
        const BallSteps steps =
            tuple_steps(balls, b, balls.lattice.alpha_on_lattice(alpha), options);
        testing::expect_star(steps, whole);
        expect_consistent(steps);
        sums.add(steps);
      }
      sums.expect(tuples);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(TupleSteps, AddUpToTheEngineOnHardSets) {
  Random random(71);
  Sums sums;
  const auto add = [&](const std::vector<NamedBalls>& sets, const auto& switches) {
    for (const NamedBalls& set : sets) {
      SCOPED_TRACE(set.name);
      const double unit = set.alpha_unit();
      expect_steps(set.balls, {-unit, 0, 2 * unit, 20 * unit}, switches, sums);
      if (::testing::Test::HasFailure()) return;
    }
  };
  add(testing::small_hard_sets(random, 8), all_optimisations());
  add(testing::large_hard_sets(random, testing::unless_sanitized(14, 6)), all_optimisations());
  sums.expect_all_seen();
}

TEST(TupleSteps, AddUpToTheEngineInAnyGrid) {
  Random random(74);
  Sums sums;
  expect_steps(testing::random_balls(random, 12, 8, 2, 5), {10}, all_switches(), sums);
}

TEST(TupleSteps, AddUpToTheEngineOnAMolecule) {
  Sums sums;
  const auto balls = testing::sample_balls("1crn.pdb");
  expect_steps(*balls, {testing::unless_sanitized(1, 0) ? 1.4 : -1}, all_optimisations(), sums);
}

// A ball reported to end a test is in conflict: its power distance at the orthocentre is not
// larger, exactly.
TEST(TupleSteps, RemoversAreInConflict) {
  Random random(72);
  const BallSet balls = testing::random_balls(random, 30, 10, 2, 5);
  int seen = 0;
  for (BallIndex b = 0; b < balls.size(); ++b) {
    const BallSteps steps = tuple_steps(balls, b, 60, {});
    if (steps.left_out != LeftOutReason::no) continue;
    for (const StepKind kind : {StepKind::filter, StepKind::exact, StepKind::faces}) {
      for (const StepConflict& remover : steps.find(kind)->removers) {
        const testing::Orthosphere sphere = testing::orthosphere(balls, remover.first);
        EXPECT_LE(testing::power_excess(balls, sphere, remover.ball), 0);
        EXPECT_EQ(std::count(remover.first.begin(), remover.first.end(), remover.ball), 0);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 200);
}

TEST(TupleSteps, PlacesAreSums) {
  const auto balls = testing::sample_balls("1crn.pdb");
  std::size_t seen = 0;
  std::uint64_t tuples = 0;
  for (BallIndex b = 0; b < balls->size(); b += 10) {
    const BallSteps steps = tuple_steps(*balls, b, balls->lattice.alpha_on_lattice(1.4), {});
    const Step& step = *steps.find(StepKind::places);
    std::uint64_t sum = 0;
    for (const StepPlace& place : step.places) {
      EXPECT_EQ(place.place, sum);
      sum += place.tuples;
      EXPECT_TRUE(std::find(place.triple.begin(), place.triple.end(), b) != place.triple.end());
    }
    EXPECT_LE(sum, step.count(id::kKept).here);
    tuples += sum;
    EXPECT_GE(step.count(id::kReserved).all, step.count(id::kKept).all);
    seen += step.places.size();
  }
  EXPECT_GT(seen, 50u);
  EXPECT_GT(tuples, 20u);
}

// The box of the ball's cell contains the ball, and the cube lies around the ball.
TEST(TupleSteps, BoxesAreWhereTheBallIs) {
  const auto balls = testing::sample_balls("1crn.pdb");
  for (const TupleGridKind grid : {TupleGridKind::automatic, TupleGridKind::thesis}) {
    TupleOptions options;
    options.grid = grid;
    const BallSteps steps = tuple_steps(*balls, 100, 0, options);
    const RealPoint p = balls->lattice.unit_angstrom() * real_point(balls->centres[100]);
    std::vector<StepBox> boxes = steps.find(StepKind::grid)->boxes;
    ASSERT_EQ(boxes.size(), 1u);
    // The number of cells from the least centre to the largest, along each axis.
    std::uint64_t cells = 1;
    for (const double RealPoint::*axis : {&RealPoint::x, &RealPoint::y, &RealPoint::z}) {
      double low = 1e300, high = -1e300;
      for (const LatticePoint& centre : balls->centres) {
        const double at = (balls->lattice.unit_angstrom() * real_point(centre)).*axis;
        low = std::min(low, at);
        high = std::max(high, at);
      }
      const double width = boxes[0].high_angstrom.*axis - boxes[0].low_angstrom.*axis;
      cells *= static_cast<std::uint64_t>(std::floor((high - low) / width * (1 + 1e-12))) + 1;
    }
    EXPECT_EQ(steps.find(StepKind::grid)->count(id::kCells).all, cells);
    for (const StepBox& box : steps.find(StepKind::cube)->boxes) boxes.push_back(box);
    ASSERT_EQ(boxes.size(), 3u);
    for (const StepBox& box : boxes) {
      EXPECT_LE(box.low_angstrom.x, p.x);
      EXPECT_GE(box.high_angstrom.x, p.x);
      EXPECT_LE(box.low_angstrom.y, p.y);
      EXPECT_GE(box.high_angstrom.y, p.y);
      EXPECT_LE(box.low_angstrom.z, p.z);
      EXPECT_GE(box.high_angstrom.z, p.z);
    }
    const double side = steps.find(StepKind::cube)->length_angstrom;
    EXPECT_NEAR(boxes[2].high_angstrom.y - p.y, side, 1e-9);
    EXPECT_GT(side, 3);
  }
}

TEST(TupleSteps, StopsAtTooManyTuples) {
  Random random(73);
  const BallSet balls = testing::random_balls(random, 200, 1000, 100, 300);
  const BallSteps steps = tuple_steps(balls, 7, 1e8, {});
  ASSERT_NE(steps.find(StepKind::too_many), nullptr);
  EXPECT_EQ(steps.steps.back().kind, StepKind::too_many);
  EXPECT_EQ(steps.steps.back().count(id::kMade).all, 199u * 198 * 197 / 6);
  EXPECT_EQ(steps.star.vertices.size(), 0u);
}

TEST(TupleSteps, RefusesWhatIsNoQuestion) {
  const auto balls = testing::sample_balls("1crn.pdb");
  EXPECT_THROW(tuple_steps(*balls, 327, 0, {}), std::invalid_argument);
  EXPECT_THROW(tuple_steps(*balls, 0, std::nan(""), {}), std::invalid_argument);
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(tuple_steps(*balls, 0, 0, {}, context), Cancelled);
}

}  // namespace
}  // namespace alphascope
