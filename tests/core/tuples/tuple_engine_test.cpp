// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the tuple engine's switches. The complex is the same byte for byte with all of them, and
// work is really done or saved.
#include "core/tuples/tuple_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/lattice_point.hpp"
#include "core/tuples/tuple_compute.hpp"
#include "core/tuples/tuple_input.hpp"
#include "tests/support/dual_edge_only_engine.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::expect_same;
using testing::NamedBalls;
using testing::Random;

std::vector<TupleOptions> all_switches() {
  std::vector<TupleOptions> all;
  for (int bits = 0; bits < 16; ++bits) {
    TupleOptions options;
    options.grid = bits & 1 ? TupleGridKind::thesis : TupleGridKind::automatic;
    options.edge_optimisation = bits & 2;
    options.alpha_optimisation = bits & 4;
    options.tuples_per_batch = bits & 8 ? 333 : 0;
    all.push_back(options);
  }
  return all;
}

std::shared_ptr<const BallSet> shared(const BallSet& balls) {
  return std::make_shared<const BallSet>(balls);
}

std::map<std::string, std::uint64_t> counters(const AlphaComplex& complex) {
  std::map<std::string, std::uint64_t> all;
  for (const EngineCounter& c : complex.engine.counters) all[c.name] = c.value;
  return all;
}

void expect_switches_change_nothing(const std::shared_ptr<const BallSet>& balls,
                                    const std::vector<double>& alphas) {
  testing::DualEdgeOnlyEngine dual_edges(balls, 1);
  std::vector<std::unique_ptr<Engine>> engines;
  for (const TupleOptions& o : all_switches()) engines.push_back(make_tuple_engine(balls, {2}, o));
  for (const double alpha : alphas) {
    for (const bool only : {false, true}) {
      const AlphaComplex expected = dual_edges.compute({alpha, only}, {});
      for (std::size_t e = 0; e < engines.size(); ++e) {
        SCOPED_TRACE("alpha " + std::to_string(alpha) + ", switches " + std::to_string(e));
        expect_same(engines[e]->compute({alpha, only}, {}), expected);
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(TupleSwitches, ChangeNothingOnHardSets) {
  Random random(31);
  for (const NamedBalls& set : testing::large_hard_sets(random, testing::unless_sanitized(18, 1))) {
    SCOPED_TRACE(set.name);
    const double unit = set.name == "extremes of the lattice" ? 1e15
                        : set.name == "random"                ? 1e4
                                                              : 1;
    std::vector<double> alphas = {-unit, 0, 0.5 * unit, 2 * unit, 20 * unit};
    if (testing::kAddressSanitizer) alphas = {0, 2 * unit};
    expect_switches_change_nothing(shared(set.balls), alphas);
  }
}

TEST(TupleSwitches, ChangeNothingOnAMolecule) {
  std::vector<double> alphas = {0};
  if (!testing::kAddressSanitizer) alphas.push_back(1.4);
  expect_switches_change_nothing(testing::sample_balls("1crn.pdb"), alphas);
}

// All balls meet, so every tuple exists and is made once.
TEST(TupleCounters, EveryTupleOnce) {
  Random random(32);
  const auto balls = shared(testing::random_balls(random, 20, 1000, 100, 300));
  for (const TupleOptions& options : all_switches()) {
    const auto found = counters(make_tuple_engine(balls, {1}, options)->compute({1e8}, {}));
    EXPECT_EQ(found.at("neighbours in cubes"), 20u * 19);
    EXPECT_EQ(found.at("pairs"), 190u);
    EXPECT_EQ(found.at("triples"), 1140u);
    EXPECT_EQ(found.at("4-tuples enumerated"), 4845u);
    EXPECT_EQ(found.at("valid 4-tuples"),
              make_tuple_engine(balls)->compute({1e8}, {}).tetrahedra.size());
  }
}

// Neighbours in the cube and their tuples, counted by definition.
struct Expected {
  std::uint64_t neighbours = 0, pairs = 0, meeting_pairs = 0, in_cube = 0, meeting = 0;
};
bool meet(const BallSet& b, BallIndex i, BallIndex j) {
  const LiftedInt v = lifted_from({b.centres[i].x, b.centres[i].y, b.centres[i].z, 0},
                                  {b.centres[j].x, b.centres[j].y, b.centres[j].z, 0});
  return static_cast<double>(v.c) <= std::pow(double(b.radii[i]) + b.radii[j], 2);
}

// With alpha = 0 and equal radii a pair's cube is the same from both sides, whatever the slots.
Expected expected_counts(const BallSet& b) {
  Expected e;
  const auto n = static_cast<BallIndex>(b.size());
  const auto near = [&](BallIndex i, BallIndex j) {
    const LatticePoint &p = b.centres[i], &q = b.centres[j];
    return std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)}) <=
           2 * b.radii[0];
  };
  for (BallIndex i = 0; i < n; ++i) {
    for (BallIndex j = i + 1; j < n; ++j) {
      e.neighbours += near(i, j) ? 2 : 0;
      e.pairs += near(i, j);
      e.meeting_pairs += meet(b, i, j);
      if (!meet(b, i, j)) continue;
      for (BallIndex k = j + 1; k < n; ++k) {
        if (!meet(b, i, k) || !meet(b, j, k)) continue;
        for (BallIndex l = k + 1; l < n; ++l) {
          e.meeting += meet(b, i, l) && meet(b, j, l) && meet(b, k, l);
        }
      }
    }
  }
  return e;
}

TEST(TupleCounters, SwitchesSaveWork) {
  Random random(33);
  const BallSet set = testing::random_balls(random, 300, 1000, 151, 151);
  const Expected expected = expected_counts(set);
  const auto balls = shared(set);
  const auto count = [&](bool edge, bool alpha) {
    TupleOptions options;
    options.edge_optimisation = edge;
    options.alpha_optimisation = alpha;
    return counters(make_tuple_engine(balls, {2}, options)->compute({0}, {}));
  };
  const auto both = count(true, true), no_alpha = count(true, false), no_edge = count(false, true),
             none = count(false, false);
  EXPECT_EQ(both.at("neighbours in cubes"), expected.neighbours);
  EXPECT_EQ(none.at("neighbours in cubes"), expected.neighbours);
  EXPECT_EQ(none.at("pairs"), expected.pairs);
  EXPECT_EQ(both.at("pairs"), expected.meeting_pairs);
  EXPECT_EQ(both.at("4-tuples enumerated"), expected.meeting);
  EXPECT_EQ(no_alpha.at("4-tuples enumerated"), expected.meeting);
  EXPECT_EQ(no_alpha.at("4-tuples into kernel II"), expected.meeting);
  EXPECT_LT(both.at("4-tuples into kernel II"), expected.meeting);
  // Without the edge optimisation, pairs, triples and tuples are all combinations in the cubes.
  EXPECT_GT(none.at("4-tuples enumerated"), 2 * expected.meeting);
  EXPECT_EQ(none.at("4-tuples enumerated"), no_edge.at("4-tuples enumerated"));
  EXPECT_EQ(none.at("4-tuples into kernel II"), none.at("4-tuples enumerated"));
  EXPECT_LT(no_edge.at("4-tuples into kernel II"), none.at("4-tuples into kernel II"));
  EXPECT_GT(both.at("valid 4-tuples"), 5u);
  EXPECT_EQ(both.at("valid 4-tuples"), none.at("valid 4-tuples"));
}

TEST(TupleCounters, FewTuplesOfAMoleculeNeedIntegers) {
  const auto balls = testing::sample_balls("1crn.pdb", 1.4);
  const auto found = counters(make_tuple_engine(balls, {2})->compute({0}, {}));
  EXPECT_GT(found.at("4-tuples into kernel II"), 10000u);
  EXPECT_LT(found.at("4-tuples into kernel III") * 100, found.at("4-tuples into kernel II"));
  EXPECT_LT(found.at("edges and triangles into kernel III") * 100, found.at("triples"));
}

TEST(TupleCounters, TiesGoToIntegers) {
  BallSet lattice;
  for (int n = 0; n < 27; ++n) {
    testing::add_ball(lattice, n % 3 * 1000, n / 3 % 3 * 1000, n / 9 * 1000, 900);
  }
  const auto found = counters(make_tuple_engine(shared(lattice), {1})->compute({0}, {}));
  EXPECT_GT(found.at("4-tuples into kernel III"), 0u);
  EXPECT_GT(found.at("valid 4-tuples"), 0u);
}

TEST(TupleEngine, NamesItsStagesInOrder) {
  const auto engine = make_tuple_engine(testing::sample_balls("1crn.pdb"), {1});
  engine->compute({1.4}, {});
  std::vector<std::string> labels;
  for (const StageTime& s : engine->compute({1.4}, {}).timings.stages) {
    labels.push_back(s.label);
    EXPECT_FALSE(s.setup) << s.label << " is paid at every alpha";
  }
  const std::vector<std::string> expected{"grid",
                                          "kernel I (candidates)",
                                          "prefix sum",
                                          "kernel II (filtered validity)",
                                          "kernel III (exact validity)",
                                          "classification",
                                          "hash and cache"};
  EXPECT_EQ(labels, expected);
}

// Streams, textures and pinned memory exist on a device only. A route on the CPU does not list them
// as left out.
TEST(TupleEngine, ItsRouteSaysWhatIsLeftOut) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const auto route = [&](const TupleOptions& options) {
    return make_tuple_engine(balls, {1}, options)->compute({0.0, true}, {}).engine.route;
  };
  EXPECT_EQ(route({}), "tuples of neighbours");
  TupleOptions plain;
  plain.pinned = plain.texture = false;
  plain.streams = 1;
  EXPECT_EQ(route(plain), "tuples of neighbours");
  plain.grid = TupleGridKind::thesis;
  plain.edge_optimisation = plain.alpha_optimisation = false;
  EXPECT_EQ(route(plain),
            "tuples of neighbours, 100 x 100 x 100 grid, without edge optimisation and alpha "
            "optimisation");
  EXPECT_EQ(tuple_route(plain, true),
            "tuples of neighbours, 100 x 100 x 100 grid, without edge optimisation and alpha "
            "optimisation and pinned memory and streams and textures");
}

// All balls meet. Without checking the token between batches this would take minutes.
TEST(TupleEngine, StopsBetweenBatches) {
  Random random(34);
  const auto balls = shared(testing::random_balls(random, 800, 1000, 100, 300));
  TupleOptions small;
  small.tuples_per_batch = 20000;
  const auto engine = make_tuple_engine(balls, {1}, small);
  RunContext context;
  double last = -1;
  int reports = 0;
  context.progress = [&](std::string_view stage, double share) {
    if (stage != stage::kCandidates) return;
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1);
    last = share;
    if (++reports == 2) context.cancel.cancel();
  };
  EXPECT_THROW(engine->compute({1e8}, context), Cancelled);
  EXPECT_EQ(reports, 2);
  EXPECT_GT(engine->compute({100}, {}).tetrahedra.size(), 0u);
}

}  // namespace
}  // namespace alphascope
