// SPDX-License-Identifier: GPL-3.0-or-later
// Tests explanations against the definition in rationals, for every simplex of small hard sets,
// whether in the triangulation or not.
#include "core/explain/explanation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "core/document/explain/simplex_details.hpp"
#include "core/document/store/inputs.hpp"
#include "core/explain/local_star.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::Random;
using testing::Rational;
using testing::RationalOracle;
using Balls = std::vector<BallIndex>;

void for_all_simplices(std::size_t count, const std::function<void(const Balls&)>& visit) {
  for (unsigned bits = 1; bits < 1u << count; ++bits) {
    Balls simplex;
    for (BallIndex v = 0; v < count; ++v) {
      if (bits >> v & 1) simplex.push_back(v);
    }
    if (simplex.size() <= 4) visit(simplex);
  }
}

bool independent(const BallSet& balls, const Balls& s) {
  const auto d = [&](std::size_t n, int axis) -> Rational {
    const LatticePoint &p = balls.centres[s[0]], &q = balls.centres[s[n]];
    return Rational(axis == 0   ? q.x
                    : axis == 1 ? q.y
                                : q.z) -
           Rational(axis == 0   ? p.x
                    : axis == 1 ? p.y
                                : p.z);
  };
  // Gram's determinant.
  const std::size_t n = s.size() - 1;
  Rational g[3][3];
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      for (int x = 0; x < 3; ++x) g[a][b] += d(a + 1, x) * d(b + 1, x);
    }
  }
  if (n == 0) return true;
  if (n == 1) return g[0][0] != 0;
  if (n == 2) return g[0][0] * g[1][1] - g[0][1] * g[1][0] != 0;
  return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) -
             g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
             g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]) !=
         0;
}

bool close(double found, const Rational& expected, const Rational& scale) {
  const Rational off = abs(Rational(found) - expected);
  return off <= abs(scale) / Rational(1e12) + abs(expected) / Rational(1e12);
}

class Checked {
 public:
  explicit Checked(const BallSet& balls) : balls_(balls), oracle_(balls) {
    const Lattice& lattice = balls.lattice;
    per_square_ = Rational(1) /
                  (Rational(lattice.units_per_angstrom()) * Rational(lattice.units_per_angstrom()));
  }

  void all() {
    for_all_simplices(balls_.size(), [&](const Balls& s) {
      if (!::testing::Test::HasFailure()) one(s);
    });
  }
  std::map<AbsenceReason, int> seen;
  std::map<Arithmetic, int> decided;

 private:
  void one(const Balls& s) {
    const Explanation e = explain(balls_, s, std::nullopt);
    const auto value = oracle_.alpha_values().find(s);
    const bool there = value != oracle_.alpha_values().end();
    ++seen[e.absence];
    ASSERT_EQ(e.absence == AbsenceReason::none, there) << name(s);
    ASSERT_EQ(e.orthosphere.has_value(), independent(balls_, s)) << name(s);
    if (e.orthosphere) sphere(e, s);
    if (there) {
      present(e, s, value->second);
    } else {
      absent(e, s);
    }
  }

  void sphere(const Explanation& e, const Balls& s) {
    const testing::Orthosphere sphere = testing::orthosphere(balls_, s);
    const Rational weight = Rational(balls_.radii[s[0]]) * balls_.radii[s[0]];
    ASSERT_TRUE(close(e.orthosphere->rho_angstrom2, sphere.rho * per_square_, weight * per_square_))
        << name(s);
    ASSERT_EQ(e.orthosphere->rho_sign, sgn(sphere.rho));
    const double unit = balls_.lattice.unit_angstrom();
    const Rational size = abs(sphere.x) + abs(sphere.y) + abs(sphere.z) + 1;
    for (const auto& [found, expected] : {std::pair(e.orthosphere->centre_angstrom.x, sphere.x),
                                          std::pair(e.orthosphere->centre_angstrom.y, sphere.y),
                                          std::pair(e.orthosphere->centre_angstrom.z, sphere.z)}) {
      ASSERT_TRUE(close(found, expected * Rational(unit), size * Rational(unit))) << name(s);
    }
    ASSERT_EQ(e.nearest.size(), std::min<std::size_t>(6, balls_.size() - s.size()));
    for (const BallMargin& one : e.nearest) margin(one, s, sphere);
  }

  void margin(const BallMargin& one, const Balls& s, const testing::Orthosphere& sphere) {
    const Rational excess = testing::power_excess(balls_, sphere, one.ball);
    ASSERT_EQ(one.sign, sgn(excess)) << name(s) << " and " << one.ball;
    ASSERT_TRUE(close(one.margin_angstrom2, excess * per_square_, excess * per_square_)) << name(s);
    ASSERT_FALSE(one.steps.empty());
    for (std::size_t n = 0; n < one.steps.size(); ++n) {
      const ArithmeticStep& step = one.steps[n];
      const bool last = n + 1 == one.steps.size();
      ASSERT_TRUE(last || step.sign == 0);
      if (step.by == Arithmetic::perturbation) continue;
      ASSERT_TRUE(step.sign == 0 || step.sign == sgn(excess)) << name(s) << " and " << one.ball;
      if (!step.has_number || std::isnan(step.value_angstrom2)) continue;
      // The number is within the filter's error bound or, without a bound, exact.
      const Rational off = abs(Rational(step.value_angstrom2) - excess * per_square_);
      const Rational allowed = std::isfinite(step.error_angstrom2)
                                   ? Rational(step.error_angstrom2) * Rational(1.0001)
                                   : off;
      ASSERT_LE(off, allowed + abs(excess) * per_square_ / Rational(1e12)) << name(s);
    }
    ++decided[one.steps.back().by];
    const bool twin = std::any_of(s.begin(), s.end(), [&](BallIndex v) {
      return balls_.centres[v] == balls_.centres[one.ball];
    });
    if (excess != 0 || twin) return;
    ASSERT_EQ(one.steps.back().by,
              s.size() % 2 == 0 ? Arithmetic::perturbation : Arithmetic::integers);
    if (s.size() == 4) {
      ASSERT_EQ(one.steps.back().sign < 0, testing::perturbed_conflict(balls_, s, one.ball));
    }
  }

  void present(const Explanation& e, const Balls& s, const Rational& value) {
    bool attached = false;
    const testing::Orthosphere sphere = testing::orthosphere(balls_, s);
    for (BallIndex m = 0; m < balls_.size(); ++m) {
      attached = attached || (std::find(s.begin(), s.end(), m) == s.end() &&
                              testing::power_excess(balls_, sphere, m) < 0);
    }
    ASSERT_EQ(e.attached, attached) << name(s);
    ASSERT_EQ(e.dimension, oracle_.dimension());
    ASSERT_EQ(e.largest, s.size() == largest_) << name(s);
    ASSERT_EQ(e.on_hull, s.size() < largest_ && !e.interior) << name(s);
    dual(e, s);
    ASSERT_EQ(e.appears.on_lattice, testing::nearest_float(value)) << name(s);
    ASSERT_EQ(e.appears.from == s, !attached);
    ASSERT_EQ(testing::orthosphere(balls_, e.appears.from).rho, value) << name(s);
    ASSERT_TRUE(std::includes(e.appears.from.begin(), e.appears.from.end(), s.begin(), s.end()));
    for (const auto& level : {e.regular, e.interior}) {
      if (level) classes(e, s, testing::orthosphere(balls_, level->from).rho);
    }
    classes(e, s, value);
  }

  // Each triangle with tetrahedra on both sides has one dual edge between their orthocentres. In
  // flat sets all dimensions are one or two lower.
  void dual(const Explanation& e, const Balls& s) {
    std::vector<std::vector<double>> expected, found;
    for (const auto& [t, value] : oracle_.alpha_values()) {
      if (t.size() != largest_ - 1 || !std::includes(t.begin(), t.end(), s.begin(), s.end()))
        continue;
      std::vector<double> ends;
      for (const auto& [c, of] : oracle_.alpha_values()) {
        if (c.size() != largest_ || !std::includes(c.begin(), c.end(), t.begin(), t.end()))
          continue;
        const testing::Orthosphere sphere = testing::orthosphere(balls_, c);
        for (const Rational& x : {sphere.x, sphere.y, sphere.z}) ends.push_back(x.get_d());
      }
      if (ends.size() == 6) expected.push_back(ends);
    }
    const double per = balls_.lattice.units_per_angstrom();
    ASSERT_EQ(e.dual_edges_angstrom.size(), expected.size()) << name(s);
    for (std::size_t n = 0; n < expected.size(); ++n) {
      const auto& [a, b] = e.dual_edges_angstrom[n];
      const double ends[] = {a.x, a.y, a.z, b.x, b.y, b.z};
      double size = 1;
      for (const double x : expected[n]) size = std::max(size, std::fabs(x));
      for (int k = 0; k < 6; ++k) {
        ASSERT_NEAR(ends[k] * per, expected[n][static_cast<std::size_t>(k)], 1e-9 * size)
            << name(s);
      }
    }
  }

  // Alphas around a critical value, and the value itself where it is a double.
  void classes(const Explanation& e, const Balls& s, const Rational& critical) {
    const double at = critical.get_d();
    // Alphas on a lattice are no finer than this.
    const double step = std::max(std::nextafter(std::fabs(at), HUGE_VAL) - std::fabs(at), 0x1p-20);
    for (const double alpha : {at - step, at, at + step}) {
      const AlphaComplex& complex = complex_at(alpha);
      const Explanation now = explain(balls_, s, alpha);
      std::optional<SimplexClass> expected;
      find(complex.vertices, s, expected);
      find(complex.edges, s, expected);
      find(complex.triangles, s, expected);
      find(complex.tetrahedra, s, expected);
      ASSERT_TRUE(now.at_alpha.has_value());
      ASSERT_EQ(now.at_alpha->in_complex, expected.has_value()) << name(s) << " at " << alpha;
      ASSERT_EQ(now.at_alpha->simplex_class, expected.value_or(SimplexClass::singular))
          << name(s) << " at " << alpha;
      // The levels agree.
      const auto reached = [&](const std::optional<AlphaLevel>& level) {
        return level && testing::orthosphere(balls_, level->from).rho <= Rational(alpha);
      };
      ASSERT_EQ(reached(e.appears), expected.has_value());
      if (expected) {
        ASSERT_EQ(*expected, s.size() == largest_   ? SimplexClass::interior
                             : !reached(e.regular)  ? SimplexClass::singular
                             : !reached(e.interior) ? SimplexClass::regular
                                                    : SimplexClass::interior)
            << name(s) << " at " << alpha;
      }
      const Rational rho = testing::orthosphere(balls_, e.appears.from).rho;
      ASSERT_FALSE(now.at_alpha->steps.empty());
      ASSERT_EQ(now.at_alpha->steps.back().sign, sgn(Rational(rho - Rational(alpha))));
    }
  }
  const AlphaComplex& complex_at(double alpha) {
    const auto found = complexes_.find(alpha);
    if (found != complexes_.end()) return found->second;
    return complexes_.emplace(alpha, oracle_.own_complex(alpha)).first->second;
  }
  template <int N>
  static void find(const SimplexList<N>& list, const Balls& s, std::optional<SimplexClass>& found) {
    for (std::size_t n = 0; n < list.size(); ++n) {
      if (std::equal(s.begin(), s.end(), list.simplices[n].begin(), list.simplices[n].end()))
        found = list.classes[n];
    }
  }

  void absent(const Explanation& e, const Balls& s) {
    const auto in = [&](const Balls& face) { return oracle_.alpha_values().count(face) != 0; };
    switch (e.absence) {
      case AbsenceReason::hidden:
        ASSERT_EQ(e.absent_face.size(), 1u);
        ASSERT_FALSE(in(e.absent_face)) << name(s);
        ASSERT_FALSE(e.culprits.empty());
        break;
      case AbsenceReason::face:
        ASSERT_GT(e.absent_face.size(), 1u);
        ASSERT_LT(e.absent_face.size(), s.size());
        ASSERT_FALSE(in(e.absent_face));
        break;
      case AbsenceReason::dependent:
        ASSERT_FALSE(independent(balls_, s));
        break;
      case AbsenceReason::cut_away:
        ASSERT_FALSE(e.culprits.empty()) << name(s);
        guilty(e, s);
        break;
      case AbsenceReason::none:
        FAIL();
    }
  }
  // Checks the culprits of a triangle or tetrahedron: if they are the only other balls, the simplex
  // is absent as well.
  void guilty(const Explanation& e, const Balls& s) {
    if (s.size() < 3) return;
    Balls few = s;
    few.insert(few.end(), e.culprits.begin(), e.culprits.end());
    std::sort(few.begin(), few.end());
    BallSet set{balls_.lattice, {}, {}};
    Balls now;
    for (std::size_t n = 0; n < few.size(); ++n) {
      set.centres.push_back(balls_.centres[few[n]]);
      set.radii.push_back(balls_.radii[few[n]]);
      if (std::binary_search(s.begin(), s.end(), few[n])) now.push_back(static_cast<BallIndex>(n));
    }
    ASSERT_EQ(RationalOracle(set).alpha_values().count(now), 0u) << name(s);
  }

  static std::string name(const Balls& s) {
    std::string text;
    for (const BallIndex v : s) text += std::to_string(v) + " ";
    return text;
  }

  const BallSet balls_;
  const RationalOracle oracle_;
  const std::size_t largest_ = static_cast<std::size_t>(oracle_.dimension()) + 1;  // vertices
  Rational per_square_;
  std::map<double, AlphaComplex> complexes_;
};

TEST(Explanation, IsTheDefinitionOnHardSets) {
  Random random(5);
  std::map<AbsenceReason, int> seen;
  std::map<Arithmetic, int> decided;
  for (const testing::NamedBalls& set : testing::small_hard_sets(random, 6)) {
    SCOPED_TRACE(set.name);
    Checked checked(set.balls);
    checked.all();
    if (HasFailure()) {
      return;
    }
    for (const auto& [what, count] : checked.seen) seen[what] += count;
    for (const auto& [what, count] : checked.decided) decided[what] += count;
  }
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(decided.size(), 4u);
}

TEST(Explanation, RefusesWhatIsNoSimplex) {
  Random random(1);
  const BallSet balls = testing::random_balls(random, 5, 5, 1, 2);
  for (const Balls& wrong : {Balls{}, Balls{1, 1}, Balls{0, 5}, Balls{0, 1, 2, 3, 4}}) {
    EXPECT_THROW(explain(balls, wrong, 1.0), std::invalid_argument);
  }
  EXPECT_THROW(explain(balls, Balls{0}, std::nan("")), std::invalid_argument);
}

// Explanations in sets that are larger than the first choice of balls. The reference is the
// filtration of the whole triangulation.
class Sampled {
 public:
  Sampled(const testing::NamedBalls& set, Random& random)
      : balls_(std::make_shared<const BallSet>(set.balls)),
        filtration_(balls_, make_triangulation(*balls_, 1)),
        random_(random) {}

  void all() {
    const AlphaComplex& top = filtration_.top();
    const ClassLevelsByDimension& levels = filtration_.levels();
    check(top.vertices, &levels.vertices);
    check(top.edges, &levels.edges);
    check(top.triangles, &levels.triangles);
    check(top.tetrahedra, nullptr);
    star({top.vertices.simplices[top.vertices.size() / 2][0]});
    if (top.edges.size() > 0) star({top.edges.simplices.back()[0], top.edges.simplices.back()[1]});
    const int last = static_cast<int>(balls_->size()) - 1;
    for (int n = 0; n < 4; ++n) {
      std::set<BallIndex> some;
      for (int v = 0; v <= n; ++v) {
        some.insert(static_cast<BallIndex>(testing::random_int(random_, 0, last)));
      }
      const Balls s(some.begin(), some.end());
      ASSERT_EQ(explain(*balls_, s, std::nullopt).absence == AbsenceReason::none, in(s));
    }
  }

 private:
  bool in(const Balls& s) const {
    const AlphaComplex& top = filtration_.top();
    return has(top.vertices, s) || has(top.edges, s) || has(top.triangles, s) ||
           has(top.tetrahedra, s);
  }
  template <int N>
  static bool has(const SimplexList<N>& list, const Balls& s) {
    return std::any_of(list.simplices.begin(), list.simplices.end(), [&](const auto& one) {
      return std::equal(one.begin(), one.end(), s.begin(), s.end());
    });
  }
  template <int N>
  void check(const SimplexList<N>& list, const ClassLevels* levels) {
    constexpr int kSamples = 6;
    for (int n = 0; n < kSamples && list.size() > 0; ++n) {
      const auto at = static_cast<std::size_t>(
          testing::random_int(random_, 0, static_cast<int>(list.size()) - 1));
      const Explanation e = explain(*balls_, list.simplices[at], std::nullopt);
      ASSERT_EQ(e.absence, AbsenceReason::none);
      ASSERT_EQ(e.appears.on_lattice, list.alpha_values[at]);
      expect_class(e);
      if (!levels || e.dimension < 3) continue;  // the filtration's dimensions are those of space
      ASSERT_EQ(e.on_hull, std::isnan(levels->interior_from[at]));
      same(e.regular, levels->regular_from[at]);
      same(e.interior, levels->interior_from[at]);
    }
  }
  // At an alpha at which it has some coface.
  void expect_class(const Explanation& e) {
    const double alpha =
        static_cast<double>((e.regular ? *e.regular : e.appears).on_lattice) * 1.5 + 1;
    const AlphaComplex complex = threshold(filtration_, alpha, false);
    const SimplexDetails expected = find_details(*balls_, complex, e.simplex);
    const Explanation now = explain(*balls_, e.simplex, alpha);
    ASSERT_EQ(now.at_alpha->in_complex, expected.in_complex);
    if (expected.in_complex) {
      ASSERT_EQ(now.at_alpha->simplex_class, expected.simplex_class);
    }
  }
  // The tetrahedra around a simplex, when only its own balls are chosen at first.
  void star(const Balls& simplex) {
    const LocalStar found = local_star(*balls_, simplex, simplex, {});
    const auto around = [&](const Balls& t) {
      return std::includes(t.begin(), t.end(), simplex.begin(), simplex.end());
    };
    std::vector<Balls> expected, mine;
    for (const auto& t : filtration_.top().tetrahedra.simplices) {
      if (around({t.begin(), t.end()})) expected.emplace_back(t.begin(), t.end());
    }
    for (const auto& t : found.triangulation.tetrahedra) {
      if (around(found.all(t))) mine.push_back(found.all(t));
    }
    ASSERT_EQ(mine, expected);
  }
  static void same(const std::optional<AlphaLevel>& found, float expected) {
    ASSERT_EQ(found.has_value(), !std::isnan(expected));
    if (found) {
      ASSERT_EQ(found->on_lattice, expected);
    }
  }

  std::shared_ptr<const BallSet> balls_;
  Filtration filtration_;
  Random& random_;
};

TEST(Explanation, IsTheFiltrationsAnswerAmongManyBalls) {
  Random random(9);
  std::vector<testing::NamedBalls> sets = testing::large_hard_sets(random, 120);
  // More ties around one point than the balls chosen there at first.
  BallSet tied = testing::random_balls(random, 0, 1, 1, 1);
  for (int x = -31; x <= 31; ++x) {
    for (int y = -31; y <= 31; ++y) {
      for (int z = -31; z <= 31; ++z) {
        if (x * x + y * y + z * z == 1001) testing::add_ball(tied, x, y, z, 1);
      }
    }
  }
  sets.push_back({"cospherical", tied});
  sets.push_back({"wide", testing::random_balls(random, 600, 4000, 100, 900)});
  for (const testing::NamedBalls& set : sets) {
    SCOPED_TRACE(set.name);
    if (set.balls.size() > 30 && !HasFailure()) Sampled(set, random).all();
  }
}

}  // namespace
}  // namespace alphascope
