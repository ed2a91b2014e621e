// SPDX-License-Identifier: GPL-3.0-or-later
// Compares predicates and filters with GMP on five balls at a time.
#include "tests/support/reference/predicate_check.hpp"

#include <cmath>

#include "core/dual_edge/facet_disc.hpp"
#include "core/dual_edge/triangle_faces.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/grown_balls.hpp"
#include "core/tuples/tuple_exact.hpp"
#include "core/tuples/tuple_float.hpp"
#include "tests/support/big_centre.hpp"
#include "tests/support/five_balls.hpp"
#include "tests/support/reference/oracle_check.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope::testing {
namespace {

LiftedVector<float> scaled(const LiftedInt& v, float scale) {
  return {static_cast<float>(v.x) * scale, static_cast<float>(v.y) * scale,
          static_cast<float>(v.z) * scale, static_cast<float>(v.c) * scale * scale};
}

bool within(const LiftedInt& v, std::int64_t bound) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) < bound;
}

struct FourNeighbours {
  LiftedInt vectors[4];
  const LiftedInt& lifted(int slot) const { return vectors[slot]; }
};

}  // namespace

// The predicates on one set of five balls. The first ball is i in orthosphere.hpp.
class PredicateCheck::Case {
 public:
  Case(PredicateCheck& check, std::uint64_t number)
      : check_(check),
        number_(number),
        random_(check.seed_ * 0x9e3779b97f4a7c15 + number),
        kind_(static_cast<int>(number % kFiveBallKinds)),
        balls_(five_balls(random_, kind_)),
        weight_(balls_.weight(0)) {
    for (BallIndex n = 0; n < 4; ++n) {
      v_[n] = lifted_vector(balls_, 0, n + 1);
      big_[n] = big_vector(balls_, 0, n + 1);
      record_[n + 1] = record(n + 1);
    }
    record_[0] = record(0);
    in_double_ = all_within(kBracketLimit);
    in_float_ = all_within(std::int64_t{1} << 24);
  }

  void run() {
    vertex();
    for (int j = 0; j < 4; ++j) {
      edge(j);
      for (int k = 0; k < 4; ++k) {
        if (k != j) triangle(j, k);
      }
    }
    for (int m = 0; m < 4; ++m) tetrahedron((m + 1) % 4, (m + 2) % 4, (m + 3) % 4, m);
    for (BallIndex a = 0; a < 5; ++a) {
      for (BallIndex b = 0; b < a; ++b) meeting(a, b);
    }
    face();
  }

 private:
  BallRecord record(BallIndex n) const {
    const LatticePoint& p = balls_.centres[n];
    return {p.x, p.y, p.z, balls_.radii[n]};
  }
  bool all_within(std::int64_t bound) const {
    bool all = true;
    for (const LiftedInt& v : v_) all = all && within(v, bound);
    return all;
  }
  bool tuples_in_float() const {
    bool all = in_float_;
    for (const int r : balls_.radii) all = all && r < 1 << 23;
    return all;
  }

  void note(const char* name, bool right, bool undecided, bool tie) {
    Count& count = check_.counts_[name];
    ++count.calls;
    count.undecided += undecided;
    count.ties += tie;
    if (right) return;
    ++count.wrong;
    if (check_.failure_.empty()) {
      check_.failure_ = std::string(name) + ", seed " + std::to_string(check_.seed_) + ", number " +
                        std::to_string(number_) + " (" + kind_of_five(kind_) + ")" +
                        list_balls(balls_);
    }
  }
  void filter(const char* name, int sign, int exact) {
    note(name, sign == 0 || sign == exact, sign == 0, exact == 0);
  }
  void filter(const char* name, Decision d, int exact) { filter(name, static_cast<int>(d), exact); }
  void exactly(const char* name, int sign, int exact) {
    note(name, sign == exact, false, exact == 0);
  }

  // Compares the bracket, comparisons around it, and the nearest float.
  void ortho_radius(std::span<const BallIndex> simplex, const Rational& rho,
                    const Bracket* bracket) {
    static const char* const kNames[3][4] = {
        {"", "edge_rho", "triangle_rho", "tetrahedron_rho"},
        {"compare_ortho_radius, vertex", "compare_ortho_radius, edge",
         "compare_ortho_radius, triangle", "compare_ortho_radius, tetrahedron"},
        {"ortho_radius_rounded, vertex", "ortho_radius_rounded, edge",
         "ortho_radius_rounded, triangle", "ortho_radius_rounded, tetrahedron"}};
    const std::size_t d = simplex.size() - 1;
    if (bracket != nullptr) {
      const bool known = bracket->error < HUGE_VAL;
      const bool holds = !known || (Rational(bracket->value - bracket->error) <= rho &&
                                    rho <= Rational(bracket->value + bracket->error));
      note(kNames[0][d], holds, !known, bracket->error == 0);
    }
    const double near = rho.get_d();
    for (const double alpha : {near, std::nextafter(near, 1e300), std::nextafter(near, -1e300),
                               near + random_int(random_, -9, 9), double(float(near))}) {
      // Skips alphas smaller than any on the lattice, and infinite ones, which are no rationals.
      if ((std::fabs(alpha) < 1e-30 && alpha != 0) || std::isinf(alpha)) continue;
      exactly(kNames[1][d], compare_ortho_radius(balls_, simplex, alpha),
              sgn(rho - Rational(alpha)));
    }
    note(kNames[2][d], ortho_radius_rounded(balls_, simplex) == nearest_float(rho), false, false);
  }

  // 0, or ±1e-16 to ±0.1. Every order of magnitude is equally likely.
  double near_nothing() {
    return random_int(random_, -1, 1) * std::pow(10, -random_int(random_, 1, 16));
  }

  void vertex() {
    const BallIndex simplex[1] = {0};
    ortho_radius(simplex, -Rational(Integer(weight_)), nullptr);
  }

  // Single precision, as devices and the tuple engine use it.
  template <int K>
  void tuple(const LiftedInt (&v)[K], const FloatCentre& centre, const BigCentre& exact,
             const Rational& rho, int m) {
    filter("FloatConflict::side", FloatConflict(centre).side(record_[0], record_[m + 1]),
           exact.cut_by(big_[m]));
    const auto alpha = static_cast<float>(rho.get_d() * (1 + near_nothing()));
    if (std::isinf(alpha)) return;
    const bool in = rho <= Rational(alpha);
    filter("centre_within", centre_within(centre, balls_.radii[0], alpha), in ? 1 : -1);
    LiftedSimplex<K + 1> simplex{{}, weight_};
    std::copy(v, v + K, simplex.v);
    note("decide_rho",
         (decide_rho<ExactDecider>(simplex, in_double_, alpha, nullptr) == Decision::in) == in,
         false, false);
  }

  void edge(int j) {
    const BigCentre exact(big_[j]);
    const Rational rho = exact.rho(weight_);
    const BallIndex simplex[2] = {0, BallIndex(j + 1)};
    const auto d = lifted_as<double>(v_[j]);
    const Bracket bracket = edge_rho(d, static_cast<double>(weight_));
    ortho_radius(simplex, rho, within_bracket_limit(v_[j]) ? &bracket : nullptr);
    const double square = std::max(rho.get_d() + static_cast<double>(weight_), 1.0);
    for (int m = 0; m < 4; ++m) {
      if (m == j) continue;
      const int cut = exact.cut_by(big_[m]);
      exactly("edge_foot_cut", edge_foot_cut(v_[j], v_[m]), cut);
      if (in_double_) {
        const auto dm = lifted_as<double>(v_[m]);
        filter("edge_foot_cut_filtered", edge_foot_cut_filtered(d, dm), cut);
        filter("FacetDisc<double>::centre_cut_by", FacetDisc<double>(d, square).centre_cut_by(dm),
               cut);
      }
      if (in_float_) {
        const FacetDisc<float> disc(scaled(v_[j], kScale),
                                    static_cast<float>(square) * kScale * kScale);
        filter("FacetDisc<float>::centre_cut_by", disc.centre_cut_by(scaled(v_[m], kScale)), cut);
      }
      if (tuples_in_float()) {
        const LiftedInt v[1] = {v_[j]};
        tuple(v, float_centre(float_lifted(record_[0], record_[j + 1])), exact, rho, m);
      }
    }
    disc_within(j, exact);
  }

  // Asks whether rho of an edge is <= alpha, near alpha.
  void disc_within(int j, const BigCentre& exact) {
    const Rational depth = exact.rho(0);
    const double square = depth.get_d() * (1 + near_nothing());
    const int in = depth <= Rational(square) ? 1 : -1;
    if (in_double_) {
      const FacetDisc<double> disc(lifted_as<double>(v_[j]), square);
      filter("FacetDisc<double>::centre_within", disc.centre_within(), in);
    }
    if (in_float_) {
      const auto near = static_cast<float>(square);
      const FacetDisc<float> disc(scaled(v_[j], kScale), near * kScale * kScale);
      filter("FacetDisc<float>::centre_within", disc.centre_within(),
             depth <= Rational(near) ? 1 : -1);
    }
  }

  void triangle(int j, int k) {
    const BigCentre exact(big_[j], big_[k]);
    if (exact.scale == 0) return;
    const Rational rho = exact.rho(weight_);
    const auto dj = lifted_as<double>(v_[j]), dk = lifted_as<double>(v_[k]);
    if (j < k) {
      const BallIndex simplex[3] = {0, BallIndex(j + 1), BallIndex(k + 1)};
      const Bracket bracket = triangle_rho(dj, dk, static_cast<double>(weight_));
      ortho_radius(simplex, rho, in_double_ ? &bracket : nullptr);
    }
    for (int m = 0; m < 4; ++m) {
      if (m == j || m == k) continue;
      const int cut = exact.cut_by(big_[m]);
      exactly("triangle_foot_cut", triangle_foot_cut(v_[j], v_[k], v_[m]), cut);
      if (in_double_) {
        filter("triangle_foot_cut_filtered",
               triangle_foot_cut_filtered(dj, dk, lifted_as<double>(v_[m])), cut);
      }
      if (tuples_in_float()) {
        const LiftedInt v[2] = {v_[j], v_[k]};
        tuple(v,
              float_centre(float_lifted(record_[0], record_[j + 1]),
                           float_lifted(record_[0], record_[k + 1])),
              exact, rho, m);
      }
    }
  }

  void tetrahedron(int j, int k, int l, int m) {
    const BigCentre exact(big_[j], big_[k], big_[l]);
    if (exact.scale == 0) return;
    const Rational rho = exact.rho(weight_);
    const BallIndex simplex[4] = {0, BallIndex(j + 1), BallIndex(k + 1), BallIndex(l + 1)};
    const Bracket bracket = tetrahedron_rho(lifted_as<double>(v_[j]), lifted_as<double>(v_[k]),
                                            lifted_as<double>(v_[l]), static_cast<double>(weight_));
    ortho_radius(simplex, rho, in_double_ ? &bracket : nullptr);
    const int side = exact.cut_by(big_[m]);
    const int cut = side != 0                                               ? side
                    : perturbed_conflict(balls_, simplex, BallIndex(m + 1)) ? 1
                                                                            : -1;
    const auto corner = [&](const char* name, int ours) {
      note(name, ours == cut, false, side == 0);
    };
    const EndBall end{l, v_[l]};
    corner("orthocentre_cut, 256 bits", orthocentre_cut<WideInt<4>>(v_[j], v_[k], end, v_[m]));
    if (all_within(kSmallOffset) && all_small(kSmallPower))
      corner("orthocentre_cut, 128 bits", orthocentre_cut<Int128>(v_[j], v_[k], end, v_[m]));
    const LiftedInt v[3] = {v_[j], v_[k], v_[l]};
    const auto conflict = [](Conflict c) { return c == Conflict::destroys ? 1 : -1; };
    corner("ExactCentre, 256 bits", conflict(ExactCentre<3, WideInt<4>>(v).with(v_[m])));
    if (all_within(kInt128TupleOffset))
      corner("ExactCentre, 128 bits", conflict(ExactCentre<3, Int128>(v).with(v_[m])));
    if (!tuples_in_float()) return;
    tuple(v,
          float_centre(float_lifted(record_[0], record_[j + 1]),
                       float_lifted(record_[0], record_[k + 1]),
                       float_lifted(record_[0], record_[l + 1])),
          exact, rho, m);
  }
  bool all_small(std::int64_t power) const {
    bool all = true;
    for (const LiftedInt& v : v_) all = all && std::abs(v.c) < power;
    return all;
  }

  // Two balls grown by 0, and by values that nearly make them touch. They meet, sqrt(a) + sqrt(b)
  // >= |d|, if |d|² - a - b is not positive or its square is at most 4 a b.
  void meeting(BallIndex a, BallIndex b) {
    const LatticePoint &p = balls_.centres[a], &q = balls_.centres[b];
    const BigVector d = big_vector(balls_, a, b);
    const double distance = std::sqrt(Integer(dot_of(d, d)).get_d());
    // For equal radii the touching point is at half the distance.
    const double grown = distance * distance / 4 - static_cast<double>(balls_.weight(a));
    for (const double wish : {0.0, grown, grown * (1 + 1e-6 * random_int(random_, -3, 3))}) {
      const double alpha =
          balls_.lattice.alpha_on_lattice(balls_.lattice.square_angstrom(wish)).nearest();
      const double wa = static_cast<double>(balls_.weight(a)) + alpha,
                   wb = static_cast<double>(balls_.weight(b)) + alpha;
      if (wa < 0 || wb < 0) continue;
      const Rational ra = Rational(Integer(balls_.weight(a))) + Rational(alpha),
                     rb = Rational(Integer(balls_.weight(b))) + Rational(alpha),
                     gap = Rational(dot_of(d, d)) - ra - rb;
      const bool meet = gap <= 0 || gap * gap <= 4 * ra * rb;
      const bool may =
          grown_balls_may_meet(q.x - p.x, q.y - p.y, q.z - p.z, grown_reach(wa), grown_reach(wb));
      // uniform_grid.cpp also needs that the filter accepts no pair far beyond.
      const bool near = distance <= (std::sqrt(wa) + std::sqrt(wb)) * (1 + 4.6e-6);
      note("grown_balls_may_meet", may ? near : !meet, may && !meet, gap * gap == 4 * ra * rb);
    }
  }

  // Triangle 012, whose dual edge 3 and 4 cut, in both precisions.
  void face() {
    const std::uint32_t others = 12;
    const TriangleRows rows{0, 1, &others, &others};
    const FourNeighbours n{{v_[0], v_[1], v_[2], v_[3]}};
    const double most = static_cast<double>(random_int(random_, 1, 1 << 30));
    const double rho = ortho_radius_rounded(balls_, std::array<BallIndex, 3>{0, 1, 2});
    const double alpha = std::round(random() & 1 ? rho : most);
    if (!(alpha + static_cast<double>(weight_) > 0) || alpha > 1e15) return;
    const double square = static_cast<double>(weight_) + alpha;
    const LatticeAlpha on_lattice(alpha);
    const Neighbourhood<FourNeighbours> in{
        n, weight_, &on_lattice, static_cast<std::int64_t>(std::sqrt(square)) + 2, in_double_};
    const TriangleFace exact = exact_face<WideInt<4>>(in, rows, 1);
    if (in_double_) {
      same_face("filtered_face<double>",
                filtered_face<double>(rows, 1, square,
                                      [&](int m) { return lifted_as<double>(n.lifted(m)); }),
                exact);
    }
    // Balls that meet, as on a device. Then neither d nor the disc's radius is longer than 1.
    if (!in_float_ || square > 1e14) return;
    same_face("filtered_face<float>",
              filtered_face<float>(rows, 1, static_cast<float>(square) * kScale * kScale,
                                   [&](int m) { return scaled(n.lifted(m), kScale); }),
              exact);
  }
  std::uint64_t random() { return random_(); }
  void same_face(const char* name, const TriangleFace& ours, const TriangleFace& exact) {
    const bool same =
        ours.in == exact.in &&
        (ours.in != Decision::in ||
         (ours.high == exact.high && ours.low == exact.low && ours.attached == exact.attached));
    note(name, ours.in == Decision::unknown || same, ours.in == Decision::unknown, false);
  }

  static constexpr float kScale = 1.0f / (1 << 24);

  PredicateCheck& check_;
  const std::uint64_t number_;
  Random random_;
  const int kind_;
  const BallSet balls_;
  const std::int64_t weight_;
  LiftedInt v_[4];
  BigVector big_[4];
  BallRecord record_[5];
  bool in_double_ = false, in_float_ = false;
};

void PredicateCheck::check(std::uint64_t number) {
  Case(*this, number).run();
}

std::uint64_t PredicateCheck::calls() const {
  std::uint64_t sum = 0;
  for (const auto& [name, count] : counts_) sum += count.calls;
  return sum;
}

std::uint64_t PredicateCheck::wrong() const {
  std::uint64_t sum = 0;
  for (const auto& [name, count] : counts_) sum += count.wrong;
  return sum;
}

void PredicateCheck::add(const PredicateCheck& other) {
  for (const auto& [name, count] : other.counts_) {
    Count& own = counts_[name];
    own.calls += count.calls;
    own.undecided += count.undecided;
    own.ties += count.ties;
    own.wrong += count.wrong;
  }
  if (failure_.empty()) failure_ = other.failure_;
}

}  // namespace alphascope::testing
