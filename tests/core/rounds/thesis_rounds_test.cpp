// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the thesis' rounds against whole triangulations, and saturation against its definition.
#include "core/rounds/thesis_rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/triangulation.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::Random;

std::shared_ptr<WorkThreads> two_threads() {
  static const auto threads = std::make_shared<WorkThreads>(2);
  return threads;
}

ThesisRounds rounds_of(const BallSet& balls) {
  return make_thesis_rounds(std::make_shared<const BallSet>(balls), two_threads());
}

// Saturation by its definition: the cell has an end on all sides, and each of its corners, which
// are orthocentres of tetrahedra, lies inside the grown ball.
class Cells {
 public:
  explicit Cells(const BallSet& balls) : balls_(balls), all_(make_triangulation(balls, 1)) {}

  const Triangulation& all() const { return all_; }
  std::vector<bool> saturated(const Alpha& alpha_angstrom2) const {
    std::vector<bool> is(balls_.size(), false);
    if (all_.dimension < 3) return is;
    for (const BallIndex i : all_.vertices) is[i] = true;
    for (const HullFacet& facet : all_.hull) {
      for (const BallIndex i : facet.balls) is[i] = false;
    }
    const LatticeAlpha alpha = balls_.lattice.alpha_on_lattice(alpha_angstrom2);
    for (const auto& t : all_.tetrahedra) {
      if (compare_ortho_radius(balls_, t, alpha) <= 0) continue;
      for (const BallIndex i : t) is[i] = false;
    }
    return is;
  }
  std::size_t tetrahedra_at(const Alpha& alpha_angstrom2) const {
    const LatticeAlpha alpha = balls_.lattice.alpha_on_lattice(alpha_angstrom2);
    return static_cast<std::size_t>(
        std::count_if(all_.tetrahedra.begin(), all_.tetrahedra.end(),
                      [&](const auto& t) { return compare_ortho_radius(balls_, t, alpha) <= 0; }));
  }

 private:
  const BallSet& balls_;
  Triangulation all_;
};

std::size_t count(const std::vector<bool>& marks) {
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), true));
}

void expect_right(const BallSet& balls, const std::string& name) {
  SCOPED_TRACE(name);
  const Cells cells(balls);
  const ThesisRounds rounds = rounds_of(balls);
  EXPECT_EQ(rounds.dimension, cells.all().dimension);
  EXPECT_TRUE(rounds.tetrahedra == cells.all().tetrahedra);
  if (rounds.dimension < 3) {
    EXPECT_TRUE(rounds.rounds.empty());
    EXPECT_TRUE(rounds.tetrahedra.empty());
    EXPECT_EQ(rounds.completion.saturated, 0u);
    return;
  }
  EXPECT_EQ(rounds.completion.hidden, cells.all().hidden.size());
  std::set<BallIndex> hull;
  for (const HullFacet& facet : cells.all().hull) {
    hull.insert(facet.balls.begin(), facet.balls.end());
  }
  EXPECT_EQ(rounds.on_hull, hull.size());
  std::size_t known = 0, saturated = 0;
  for (const ThesisRound& round : rounds.rounds) {
    SCOPED_TRACE("alpha " + round.alpha_angstrom2.digits());
    const bool last = &round == &rounds.rounds.back();
    const bool changed = round.new_tetrahedra > 0 || round.saturated > saturated;
    if (known > 0 && rounds.rounds.size() < kMostRounds) {
      EXPECT_EQ(last, !changed) << "they end when a round changes nothing";
    }
    saturated = round.saturated;
    EXPECT_EQ(round.saturated, count(cells.saturated(round.alpha_angstrom2)));
    EXPECT_EQ(round.tetrahedra, cells.tetrahedra_at(round.alpha_angstrom2));
    EXPECT_EQ(round.saturated + round.hidden + round.unsaturated, balls.size());
    EXPECT_LE(round.hidden, cells.all().hidden.size());
    EXPECT_EQ(round.new_tetrahedra, round.tetrahedra - known);
    EXPECT_NE(round.route, "");
    known = round.tetrahedra;
  }
  EXPECT_EQ(rounds.completion.tetrahedra, cells.all().tetrahedra.size());
  EXPECT_EQ(rounds.completion.new_tetrahedra, rounds.completion.tetrahedra - known);
  EXPECT_EQ(rounds.completion.unsaturated, rounds.on_hull)
      << "at the end all others are saturated or hidden";
}

// The stars of saturated balls are final: every tetrahedron of the whole triangulation with such a
// ball is in the list.
void expect_final_stars(const BallSet& balls, const Alpha& alpha) {
  SCOPED_TRACE("alpha " + alpha.digits());
  const Cells cells(balls);
  const auto engine = make_cpu_engine(std::make_shared<const BallSet>(balls), {.threads = 1});
  const Simplices<4> known = engine->compute({alpha, true}, {}).tetrahedra.simplices;
  const std::vector<bool> saturated = saturated_balls(balls.size(), known);
  EXPECT_EQ(saturated, cells.saturated(alpha));
  const auto star = [](const Simplices<4>& tetrahedra, BallIndex i) {
    Simplices<4> of;
    for (const auto& t : tetrahedra) {
      if (std::find(t.begin(), t.end(), i) != t.end()) of.push_back(t);
    }
    return of;
  };
  for (BallIndex i = 0; i < balls.size(); ++i) {
    if (saturated[i]) {
      EXPECT_TRUE(star(known, i) == star(cells.all().tetrahedra, i)) << i;
    }
  }
}

BallSet lattice_of_balls(int side, int distance, int radius) {
  BallSet balls;
  balls.lattice.digits = 0;  // a unit is 1 Å
  for (int n = 0; n < side * side * side; ++n) {
    add_ball(balls, distance * (n % side), distance * (n / side % side),
             distance * (n / side / side), radius);
  }
  return balls;
}

TEST(ThesisRounds, GiveTheWholeTriangulationOfHardSets) {
  Random random(11);
  for (int n = 0; n < 6; ++n) {
    for (const auto& set : testing::small_hard_sets(random, 30)) expect_right(set.balls, set.name);
  }
  for (const auto& set : testing::large_hard_sets(random, 200)) expect_right(set.balls, set.name);
}

TEST(ThesisRounds, GiveTheWholeTriangulationOfRandomBallsAndLattices) {
  Random random(12);
  for (const int extent : {6, 15, 40}) {
    for (int n = 0; n < 8; ++n) {
      expect_right(testing::random_balls(random, 150, extent, 1, 6),
                   "extent " + std::to_string(extent));
    }
  }
  expect_right(lattice_of_balls(6, 2, 1), "a lattice of ties");
  expect_right(lattice_of_balls(5, 9, 2), "a wide lattice");
}

TEST(ThesisRounds, GiveTheWholeTriangulationOfMolecules) {
  expect_right(*testing::sample_balls("1crn.pdb"), "1crn");
  expect_right(*testing::sample_balls("1crn.pdb", 1.4), "1crn with solvent");
}

TEST(ThesisRounds, SaturateNobodyBelowThreeDimensions) {
  BallSet balls;
  balls.lattice.digits = 0;
  expect_right(balls, "none");
  add_ball(balls, 3, 4, 5, 2);
  expect_right(balls, "one");
  add_ball(balls, 3, 4, 5, 2);
  expect_right(balls, "equal");
  for (int n = 0; n < 30; ++n) add_ball(balls, 4 * (n % 6), 4 * (n / 6), 5, 2);
  expect_right(balls, "flat");
  add_ball(balls, 10, 10, 12, 2);
  expect_right(balls, "a roof");
}

// Eight small balls are hidden by a large one that saturates early. Far away, a hull needs later
// rounds, which leave the large ball out.
TEST(ThesisRounds, HiddenBallsStayHiddenWithoutThoseThatHideThem) {
  BallSet balls = lattice_of_balls(9, 4, 2);
  for (int n = 0; n < 8; ++n)
    add_ball(balls, n % 2 ? 17 : 15, n / 2 % 2 ? 17 : 15, n / 4 ? 17 : 15, 1);
  balls.radii[4 + 9 * 4 + 81 * 4] = 4;
  for (int n = 0; n < 8; ++n)
    add_ball(balls, n % 2 ? 90 : -60, n / 2 % 2 ? 85 : -70, n / 4 ? 120 : -50, 1);
  expect_right(balls, "hidden");
  const ThesisRounds rounds = rounds_of(balls);
  EXPECT_EQ(rounds.completion.hidden, 8u);
  bool small = false;
  for (const ThesisRound& round : rounds.rounds) {
    EXPECT_TRUE(round.hidden == 8 || round.balls == balls.size());
    small = small || round.balls + 100 < balls.size();
  }
  EXPECT_TRUE(small) << "the large ball has left, and so have those that it hides";
}

// Three groups of balls, each with larger gaps than the one before. The first tetrahedra of a later
// group are far from all that is known. The middle of the first group has left by then.
TEST(ThesisRounds, FindGroupsThatGrowTogetherLater) {
  BallSet balls = lattice_of_balls(8, 3, 2);
  for (const int distance : {6, 11}) {
    for (int n = 0; n < 64; ++n) {
      add_ball(balls, 1000 * (distance - 5) + distance * (n % 4), distance * (n / 4 % 4),
               distance * (n / 16), 2);
    }
  }
  expect_right(balls, "three groups");
  const ThesisRounds rounds = rounds_of(balls);
  ASSERT_GE(rounds.rounds.size(), 4u);
  for (const std::size_t n : {1, 2, 3}) EXPECT_GT(rounds.rounds[n].new_tetrahedra, 100u) << n;
}

TEST(ThesisRounds, StarsOfSaturatedBallsAreFinal) {
  Random random(13);
  for (int n = 0; n < 6; ++n) {
    const BallSet balls = testing::random_balls(random, 60, 12, 1, 4);
    for (const double alpha : {-1.0, 2.5, 10.0, 25.0, 40.0, 160.0}) {
      expect_final_stars(balls, alpha);
    }
  }
  expect_final_stars(lattice_of_balls(4, 4, 2), 8.0);
  expect_final_stars(*testing::sample_balls("1crn.pdb"), 10.0);
}

// The middle ball of a cube has its corners of the cell at a squared distance of 12, as the centre
// of each of eight smaller cubes is as near to it as to seven others.
TEST(ThesisRounds, ABallIsSaturatedFromTheFarthestCornerOfItsCellOn) {
  const BallSet balls = lattice_of_balls(3, 4, 2);
  const BallIndex middle = 13;
  const auto saturated_at = [&](const Alpha& alpha) {
    const auto engine = make_cpu_engine(std::make_shared<const BallSet>(balls), {.threads = 1});
    return saturated_balls(balls.size(), engine->compute({alpha, true}, {}).tetrahedra.simplices);
  };
  Alpha below, above;
  ASSERT_EQ(Alpha::read("7.999999999999999999", below), Alpha::Reading::ok);
  ASSERT_EQ(Alpha::read("8.000000000000000001", above), Alpha::Reading::ok);
  EXPECT_EQ(count(saturated_at(below)), 0u);
  for (const Alpha& alpha : {Alpha(8), above}) {
    EXPECT_EQ(count(saturated_at(alpha)), 1u);
    EXPECT_TRUE(saturated_at(alpha)[middle]);
  }
}

// One tetrahedron less leaves four open triangles, and none of its balls is saturated.
TEST(ThesisRounds, OneMissingTetrahedronOpensItsBalls) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const Triangulation all = make_triangulation(*balls, 1);
  const std::vector<bool> before = saturated_balls(balls->size(), all.tetrahedra);
  for (std::size_t n = 0; n < all.tetrahedra.size(); n += 97) {
    Simplices<4> rest = all.tetrahedra;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(n));
    std::vector<bool> expected = before;
    for (const BallIndex i : all.tetrahedra[n]) expected[i] = false;
    EXPECT_EQ(saturated_balls(balls->size(), rest), expected);
  }
}

TEST(ThesisRounds, AlphaIsFourTimesThatOfTheRoundBefore) {
  EXPECT_EQ(alpha_of_round(1), Alpha(2.5));
  EXPECT_EQ(alpha_of_round(2), Alpha(10));
  EXPECT_EQ(alpha_of_round(3), Alpha(40));
  EXPECT_TRUE(alpha_of_round(kMostRounds).is_decimal());
}

TEST(ThesisRounds, CanBeCancelledAtEveryReport) {
  const auto balls = testing::sample_balls("1crn.pdb");
  int reports = 0;
  RunContext counting;
  counting.progress = [&](std::string_view, double) { ++reports; };
  make_thesis_rounds(balls, two_threads(), counting);
  ASSERT_GT(reports, 5);
  for (int at = 1; at <= reports; ++at) {
    RunContext context;
    int seen = 0;
    context.progress = [&](std::string_view, double) {
      if (++seen == at) context.cancel.cancel();
    };
    EXPECT_THROW(make_thesis_rounds(balls, two_threads(), context), Cancelled) << at;
  }
}

}  // namespace
}  // namespace alphascope
