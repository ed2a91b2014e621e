// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the steps of one ball through the dual-edge engine. Summed over all balls, the numbers are
// those of the engine. The result is the star of the ball in CGAL's complex.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/route.hpp"
#include "core/explain/ball_steps.hpp"
#include "core/geometry/alpha.hpp"
#include "core/neighbours/coincident.hpp"
#include "tests/core/explain/star_of.hpp"
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

// Every simplex is kept or dropped by exactly one step, and each step begins with those that the
// last one kept.
void expect_consistent(const BallSteps& steps) {
  if (steps.left_out != LeftOutReason::no) {
    EXPECT_EQ(steps.steps.size(), 1u);
    return;
  }
  const auto expect_sum = [&](StepKind kind, std::string_view whole,
                              const std::vector<std::string_view>& parts) {
    std::uint64_t all = 0, here = 0;
    for (const std::string_view part : parts) {
      all += steps.find(kind)->count(part).all;
      here += steps.find(kind)->count(part).here;
    }
    EXPECT_EQ(steps.find(kind)->count(whole).all, all) << whole;
    EXPECT_EQ(steps.find(kind)->count(whole).here, here) << whole;
  };
  const auto expect_passed = [&](StepKind from, std::string_view left, StepKind to,
                                 std::string_view gets) {
    EXPECT_EQ(steps.find(from)->count(left).all, steps.find(to)->count(gets).all) << gets;
    EXPECT_EQ(steps.find(from)->count(left).here, steps.find(to)->count(gets).here) << gets;
  };
  expect_passed(StepKind::neighbours, id::kNeighbours, StepKind::discs, id::kMade);
  expect_sum(StepKind::discs, id::kMade, {id::kDropped, id::kKept});
  expect_sum(StepKind::edges, id::kTested, {id::kConflict, id::kAboveAlpha, id::kValid});
  EXPECT_EQ(steps.find(StepKind::discs)->count(id::kKept).here,
            steps.find(StepKind::edges)->count(id::kTested).here);
  expect_sum(StepKind::triangles, id::kMade, {id::kDropped, id::kKept});
  expect_passed(StepKind::triangles, id::kKept, StepKind::clipping, id::kTested);
  expect_sum(StepKind::clipping, id::kTested, {id::kOutside, id::kConflict, id::kLeft, id::kBand});
  expect_passed(StepKind::clipping, id::kBand, StepKind::exact, id::kTested);
  expect_sum(StepKind::exact, id::kTested, {id::kConflict, id::kFlat, id::kLeft});
  expect_sum(StepKind::ends, id::kTested, {id::kAboveAlpha, id::kTriangles});
  EXPECT_EQ(steps.find(StepKind::ends)->count(id::kTested).all,
            steps.find(StepKind::clipping)->count(id::kLeft).all +
                steps.find(StepKind::exact)->count(id::kLeft).all);
  expect_passed(StepKind::ends, id::kTriangles, StepKind::result, id::kTriangles);
  expect_passed(StepKind::ends, id::kTetrahedra, StepKind::result, id::kTetrahedra);
  for (const StepKind kind : {StepKind::edges, StepKind::clipping, StepKind::exact}) {
    std::uint64_t removed = 0, listed = 0;
    for (const StepConflict& remover : steps.find(kind)->removers) removed += remover.simplices;
    EXPECT_EQ(removed, steps.find(kind)->count(id::kConflict).all);
    for (const MarkedSimplices& m : steps.find(kind)->marks)
      listed += m.edges.size() + m.triangles.size() + m.left_out;
    EXPECT_EQ(listed, steps.find(kind)->count(id::kTested).all);
  }
}

// Numbers that the engine counts. Each dual edge belongs to three balls, and each simplex to its
// vertices.
class Sums {
 public:
  void add(const BallSteps& steps) {
    if (steps.left_out != LeftOutReason::no) return;
    const auto add = [&](Tally& tally, StepKind kind, std::string_view what) {
      const StepCount& count = steps.find(kind)->count(what);
      tally.all += count.all;
      tally.here += count.here;
    };
    add(dual_edges_, StepKind::clipping, id::kTested);
    add(exact_, StepKind::exact, id::kTested);
    add(triples_, StepKind::triangles, id::kMade);
    add(held_, StepKind::clipping, id::kHeld);
    add(tested_edges_, StepKind::edges, id::kTested);
    add(vertices_, StepKind::result, id::kVertices);
    add(edges_, StepKind::result, id::kEdges);
    add(triangles_, StepKind::result, id::kTriangles);
    add(tetrahedra_, StepKind::result, id::kTetrahedra);
  }
  void expect(const DualEdgeStatistics& engine, const AlphaComplex& complex) {
    expect(dual_edges_, 3, engine.dual_edges, "dual edges");
    expect(exact_, 3, engine.exact, "exact dual edges");
    expect(triples_, 3, triples_.here, "triples");
    expect(held_, 3, held_.here, "balls held against dual edges");
    expect(tested_edges_, 2, tested_edges_.here, "edges tested");
    expect(vertices_, 1, complex.vertices.size(), "vertices");
    expect(edges_, 2, complex.edges.size(), "edges");
    expect(triangles_, 3, complex.triangles.size(), "triangles");
    expect(tetrahedra_, 4, complex.tetrahedra.size(), "tetrahedra");
    seen_exact_ += engine.exact;
    seen_ += engine.dual_edges;
    *this = Sums(seen_, seen_exact_);
  }
  std::uint64_t seen() const { return seen_; }
  std::uint64_t seen_exact() const { return seen_exact_; }

  Sums() = default;

 private:
  struct Tally {
    std::uint64_t all = 0, here = 0;
  };
  Sums(std::uint64_t seen, std::uint64_t exact) : seen_(seen), seen_exact_(exact) {}
  static void expect(const Tally& tally, std::uint64_t balls, std::uint64_t engine,
                     const char* what) {
    EXPECT_EQ(tally.here, engine) << what;
    EXPECT_EQ(tally.all, balls * engine) << what;
  }

  Tally dual_edges_, exact_, triples_, held_, tested_edges_, vertices_, edges_, triangles_,
      tetrahedra_;
  std::uint64_t seen_ = 0, seen_exact_ = 0;
};

void expect_steps(const BallSet& balls, const std::vector<double>& alphas, Sums& sums) {
  const auto shared = std::make_shared<const BallSet>(balls);
  const auto cgal = testing::keeping(make_cgal_engine(shared, {1}));
  for (const double alpha_angstrom2 : alphas) {
    SCOPED_TRACE("alpha " + std::to_string(alpha_angstrom2));
    const double alpha = balls.lattice.alpha_on_lattice(alpha_angstrom2).nearest();
    const AlphaComplex whole = cgal->compute({alpha_angstrom2}, {});
    const UniformGrid grid = make_uniform_grid(balls, alpha, coincident_hidden(balls));
    if (!within_clipping_reach(grid)) {
      for (const BallIndex b : grid.ball) {
        EXPECT_NE(dual_edge_steps(balls, b, alpha).find(StepKind::beyond_range), nullptr);
      }
      continue;
    }
    AlphaComplex complex;
    complex.lattice = balls.lattice;
    complex.alpha_on_lattice = alpha;
    StageTimer timer(complex.timings);
    const DualEdgeStatistics engine = compute_by_dual_edges(balls, grid, {}, timer, complex);
    for (BallIndex b = 0; b < balls.size(); ++b) {
      const BallSteps steps = dual_edge_steps(balls, b, alpha);
      testing::expect_star(steps, whole);
      expect_consistent(steps);
      sums.add(steps);
      if (::testing::Test::HasFailure()) return;
    }
    sums.expect(engine, complex);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(DualEdgeSteps, AddUpToTheEngineOnHardSets) {
  Random random(81);
  Sums sums;
  for (const bool large : {false, true}) {
    for (const NamedBalls& set :
         large ? testing::large_hard_sets(random, testing::unless_sanitized(35, 12))
               : testing::small_hard_sets(random, 10)) {
      SCOPED_TRACE(set.name);
      const double unit = set.alpha_unit();
      expect_steps(set.balls, {-unit, 0, 2 * unit, 20 * unit, 1000 * unit}, sums);
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(sums.seen(), 10'000u);
  EXPECT_GT(sums.seen_exact(), 3'000u);
}

TEST(DualEdgeSteps, AddUpToTheEngineOnAMolecule) {
  Sums sums;
  expect_steps(*testing::sample_balls("1crn.pdb"), {-1, 1.4, testing::unless_sanitized(10, 3)},
               sums);
  EXPECT_GT(sums.seen(), 10'000u);
}

RealPoint point(const BallSet& balls, BallIndex b) {
  return balls.lattice.unit_angstrom() * real_point(balls.centres[b]);
}
double power(const BallSet& balls, BallIndex b, const RealPoint& x) {
  const RealPoint d = x - point(balls, b);
  return dot(d, d) - balls.lattice.square_angstrom(static_cast<double>(balls.weight(b)));
}

// On the part of a dual edge that clipping leaves, three balls have equal power and no ball has
// less. That part lies within the grown ball, or slightly beyond.
TEST(DualEdgeSteps, SegmentsAreDualEdges) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const double alpha = 4;
  std::size_t seen = 0;
  for (BallIndex b = 0; b < balls->size(); b += 13) {
    const BallSteps steps = dual_edge_steps(*balls, b, balls->lattice.alpha_on_lattice(alpha));
    const Step& step = *steps.find(StepKind::clipping);
    EXPECT_EQ(step.segments.size(), step.count(id::kLeft).all);
    for (const StepSegment& segment : step.segments) {
      for (const RealPoint& x : {segment.from_angstrom, segment.to_angstrom}) {
        const double least = power(*balls, segment.triangle[0], x);
        EXPECT_NEAR(power(*balls, segment.triangle[1], x), least, 1e-6);
        EXPECT_NEAR(power(*balls, segment.triangle[2], x), least, 1e-6);
        EXPECT_LT(least, alpha + 1e-3);
        for (BallIndex m = 0; m < balls->size(); ++m) {
          // Farther balls may cut where nothing is within alpha.
          if (least > alpha - 1e-3) break;
          EXPECT_GT(power(*balls, m, x), least - 1e-6);
        }
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 200u);
}

// With each ball the rest shrinks, and it does not change once it has settled.
TEST(DualEdgeSteps, CutsShortenDualEdges) {
  const auto balls = testing::sample_balls("1crn.pdb");
  std::map<CutKind, std::size_t> seen;
  std::map<StepMark, std::size_t> fates;
  for (BallIndex b = 0; b < balls->size(); b += 9) {
    const BallSteps steps = dual_edge_steps(*balls, b, balls->lattice.alpha_on_lattice(3));
    for (const StepDualEdge& edge : steps.find(StepKind::clipping)->dual_edges) {
      ++fates[edge.mark];
      double low = edge.low_angstrom, high = edge.high_angstrom;
      EXPECT_LT(low, high);
      for (std::size_t n = 0; n < edge.cuts.size(); ++n) {
        const StepCut& cut = edge.cuts[n];
        ++seen[cut.kind];
        EXPECT_EQ(std::count(edge.triangle.begin(), edge.triangle.end(), cut.ball), 0);
        EXPECT_GE(cut.low_angstrom, low);
        EXPECT_LE(cut.high_angstrom, high);
        const bool same = cut.low_angstrom == low && cut.high_angstrom == high;
        EXPECT_EQ(cut.kind == CutKind::moves_end, !same);
        EXPECT_TRUE(same || n < edge.settled_after());
        EXPECT_EQ(cut.kind == CutKind::takes_rest,
                  edge.mark == StepMark::dropped && n + 1 == edge.cuts.size());
        low = cut.low_angstrom;
        high = cut.high_angstrom;
      }
    }
  }
  for (const CutKind kind :
       {CutKind::too_far, CutKind::nothing, CutKind::moves_end, CutKind::takes_rest})
    EXPECT_GT(seen[kind], 20u) << static_cast<int>(kind);
  EXPECT_GT(fates[StepMark::kept], 20u);
  EXPECT_GT(fates[StepMark::dropped], 20u);
}

// Where few dual edges are clipped, all are listed.
TEST(DualEdgeSteps, CountsWhatItLists) {
  const auto balls = testing::sample_balls("1crn.pdb");
  std::size_t seen = 0;
  for (BallIndex b = 0; b < balls->size(); ++b) {
    const BallSteps steps = dual_edge_steps(*balls, b, balls->lattice.alpha_on_lattice(0));
    const Step& step = *steps.find(StepKind::clipping);
    std::size_t clipped = 0;
    for (const auto what : {id::kConflict, id::kLeft, id::kBand}) clipped += step.count(what).all;
    if (step.dual_edges.size() < clipped) continue;
    std::map<CutKind, std::uint64_t> found;
    std::uint64_t all = 0;
    for (const StepDualEdge& edge : step.dual_edges) {
      all += edge.cuts.size();
      for (const StepCut& cut : edge.cuts) ++found[cut.kind];
    }
    EXPECT_EQ(step.count(id::kHeld).all, all);
    EXPECT_EQ(step.count(id::kFar).all, found[CutKind::too_far]);
    EXPECT_EQ(step.count(id::kMoved).all, found[CutKind::moves_end]);
    EXPECT_EQ(step.count(id::kConflict).all, found[CutKind::takes_rest]);
    seen += found[CutKind::too_far] > 0 && found[CutKind::moves_end] > 0;
  }
  EXPECT_GT(seen, 50u);
}

// A ball reported to attach an edge is in conflict with it, exactly.
TEST(DualEdgeSteps, RemoversOfEdgesAreInConflict) {
  Random random(82);
  const BallSet balls = testing::random_balls(random, 40, 10, 2, 5);
  int seen = 0;
  for (BallIndex b = 0; b < balls.size(); ++b) {
    const BallSteps steps = dual_edge_steps(balls, b, 60);
    if (steps.left_out != LeftOutReason::no) continue;
    for (const StepConflict& remover : steps.find(StepKind::edges)->removers) {
      const testing::Orthosphere sphere = testing::orthosphere(balls, remover.first);
      EXPECT_LE(testing::power_excess(balls, sphere, remover.ball), 0);
      EXPECT_EQ(std::count(remover.first.begin(), remover.first.end(), remover.ball), 0);
      ++seen;
    }
  }
  EXPECT_GT(seen, 100);
}

// Balls of a cubic lattice. The middle of a square's diagonal is equally near to the other two
// balls, and the ends of dual edges are ties.
TEST(DualEdgeSteps, TiesAreSaidOnceAndDecidedByIntegers) {
  BallSet balls;
  for (int i = 0; i < 27; ++i) {
    testing::add_ball(balls, 1000 * (i % 3), 1000 * (i / 3 % 3), 1000 * (i / 9), 700);
  }
  const BallSteps steps = dual_edge_steps(balls, 13, 300'000);
  EXPECT_GT(steps.find(StepKind::edges)->count(id::kIntegers).all, 0u);
  std::size_t unclear = 0;
  for (const StepDualEdge& edge : steps.find(StepKind::clipping)->dual_edges) {
    for (std::size_t n = 0; n < edge.cuts.size(); ++n) {
      if (edge.cuts[n].kind != CutKind::unclear) continue;
      ++unclear;
      EXPECT_TRUE(n == 0 || edge.cuts[n - 1].kind != CutKind::unclear) << "said already";
    }
  }
  EXPECT_GT(unclear, 0u);
}

TEST(DualEdgeSteps, BoxesAndSpheresAreWhereTheBallIs) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const BallSteps steps = dual_edge_steps(*balls, 100, balls->lattice.alpha_on_lattice(1.4));
  const RealPoint p = point(*balls, 100);
  const StepBox cell = steps.find(StepKind::grid)->boxes.at(0),
                searched = steps.find(StepKind::neighbours)->boxes.at(0);
  for (const StepBox& box : {cell, searched}) {
    for (const double RealPoint::*axis : {&RealPoint::x, &RealPoint::y, &RealPoint::z}) {
      EXPECT_LE(box.low_angstrom.*axis, p.*axis);
      EXPECT_GE(box.high_angstrom.*axis, p.*axis);
    }
  }
  EXPECT_LE(searched.low_angstrom.x, cell.low_angstrom.x);
  const StepSphere sphere = steps.find(StepKind::neighbours)->spheres.at(0);
  EXPECT_EQ(sphere.centre_angstrom, p);
  const double radius = balls->lattice.angstrom(balls->radii[100]);
  EXPECT_NEAR(sphere.radius_angstrom, std::sqrt(radius * radius + 1.4), 1e-4);
  for (const StepKind kind : {StepKind::neighbours, StepKind::clipping}) {
    EXPECT_NEAR(steps.find(kind)->length_angstrom, sphere.radius_angstrom, 1e-9);
  }
}

TEST(DualEdgeSteps, OneBallIsItsOwnStar) {
  BallSet balls;
  testing::add_ball(balls, 0, 0, 0, 3);
  const BallSteps steps = dual_edge_steps(balls, 0, 0);
  EXPECT_EQ(steps.find(StepKind::neighbours)->count(id::kNeighbours).all, 0u);
  EXPECT_EQ(steps.find(StepKind::result)->count(id::kVertices).here, 1u);
  EXPECT_EQ(steps.star.vertices.size(), 1u);
  EXPECT_EQ(dual_edge_steps(balls, 0, -100).left_out, LeftOutReason::empty);
  testing::add_ball(balls, 0, 0, 0, 2);
  EXPECT_EQ(dual_edge_steps(balls, 1, 0).left_out, LeftOutReason::hidden);
}

TEST(DualEdgeSteps, StopsAtTooMuch) {
  Random random(83);
  const BallSet balls = testing::random_balls(random, 800, 1000, 100, 300);
  const BallSteps steps = dual_edge_steps(balls, 0, 1e8);
  EXPECT_EQ(steps.steps.back().kind, StepKind::too_many);
  EXPECT_EQ(steps.star.vertices.size(), 0u);
  for (const double alpha : {1e30, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(dual_edge_steps(balls, 0, alpha).steps.back().kind, StepKind::beyond_range);
  }
}

TEST(DualEdgeSteps, RefusesWhatIsNoQuestion) {
  const auto balls = testing::sample_balls("1crn.pdb");
  EXPECT_THROW(dual_edge_steps(*balls, 327, 0), std::invalid_argument);
  EXPECT_THROW(dual_edge_steps(*balls, 0, std::nan("")), std::invalid_argument);
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(dual_edge_steps(*balls, 0, 0, context), Cancelled);
}

}  // namespace
}  // namespace alphascope
