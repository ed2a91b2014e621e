// SPDX-License-Identifier: GPL-3.0-or-later
// Repeats an engine's comparison in each arithmetic and records the steps.
#include "core/explain/recorded_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/dual_edge/exact_dual_edge.hpp"
#include "core/dual_edge/facet_disc.hpp"
#include "core/verify/verify_orthosphere.hpp"

namespace alphascope {
namespace {

using Steps = std::vector<ArithmeticStep>;

// Offsets below this are exact in single precision, as dual_edge.hpp requires.
constexpr std::int64_t kSingleLimit = std::int64_t{1} << 24;

template <class Real>
bool filter_holds(const LiftedInt& v) {
  constexpr std::int64_t kLimit = sizeof(Real) == 4 ? kSingleLimit : kBracketLimit;
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) < kLimit;
}
template <class Real>
constexpr Arithmetic kFilter = sizeof(Real) == 4 ? Arithmetic::single_filter
                                                 : Arithmetic::double_filter;

int outside_unless(Decision cut) {
  return -static_cast<int>(cut);
}

double quotient(const ExactRho& rho) {
  return rho.numerator.near_double() / rho.denominator.near_double();
}

// Records one comparison: steps until one decides.
class Recorder {
 public:
  Recorder(const BallSet& balls, std::span<const BallIndex> simplex)
      : unit_(balls.lattice.square_angstrom(1)) {
    for (std::size_t n = 1; n < simplex.size(); ++n) {
      v_[n - 1] = lifted_vector(balls, simplex[0], simplex[n]);
    }
    weight_ = balls.weight(simplex[0]);
  }
  bool decided() const { return !steps_.empty() && steps_.back().sign != 0; }
  // `value` and `error` in square lattice units; recorded in Å².
  void add(Arithmetic by, int sign, double value, double error) {
    steps_.push_back({by, sign, true, value * unit_, error * unit_});
  }
  void add(Arithmetic by, int sign) { steps_.push_back({by, sign}); }
  Steps take() { return std::move(steps_); }

  const LiftedInt& v(int n) const { return v_[n]; }
  std::int64_t weight() const { return weight_; }

 private:
  double unit_;
  LiftedInt v_[3] = {};
  std::int64_t weight_ = 0;
  Steps steps_;
};

template <class Real>
bool all_within(const Recorder& r, int count) {
  for (int n = 0; n < count; ++n) {
    if (!filter_holds<Real>(r.v(n))) return false;
  }
  return true;
}

// Records whether m cuts off the centre of an edge's disc.
template <class Real>
void filter_edge(Recorder& r, const LiftedInt& m) {
  double gap = 0, error = 0;
  const FacetDisc<Real> disc(lifted_as<Real>(r.v(0)), Real(1));
  const Decision cut = disc.centre_cut_by(lifted_as<Real>(m), [&](Real value, Real bound) {
    gap = static_cast<double>(value);
    error = static_cast<double>(bound);
  });
  r.add(kFilter<Real>, outside_unless(cut), -gap, error);
}

// Records whether m cuts off the foot on a triangle's line. `reach` is a squared distance beyond
// the foot.
template <class Real>
void filter_triangle(Recorder& r, const LiftedInt& m, double reach) {
  using Edge = DualEdge<Real>;
  Edge edge;
  if (!edge.start(lifted_as<Real>(r.v(0)), lifted_as<Real>(r.v(1)), static_cast<Real>(reach))) {
    return r.add(kFilter<Real>, 0);
  }
  const auto cut = edge.cut_by(lifted_as<Real>(m));
  int sign = 0;
  switch (edge.takes(cut)) {
    case Edge::Takes::nothing:
      sign = 1;
      break;
    case Edge::Takes::all:
      sign = -1;
      break;
    case Edge::Takes::some: {
      edge.clip(cut, 0);
      const auto& end = cut.slope > 0 ? edge.high() : edge.low();
      // An end without a ball is the boundary of the search, far beyond the foot.
      if (edge.ends_certain()) sign = end.cutter < 0 ? 1 : outside_unless(Edge::cuts_off_foot(end));
    }
  }
  r.add(kFilter<Real>, sign, 2.0 * cut.offset, 2.0 * cut.offset_error);
}

// Makes the dual edge of a tetrahedron's first three balls, ended by the fourth. Returns false if
// the filter cannot do so with certainty.
template <class Real>
bool end_by_fourth(const Recorder& r, double reach, DualEdge<Real>& edge) {
  if (!edge.start(lifted_as<Real>(r.v(0)), lifted_as<Real>(r.v(1)), static_cast<Real>(reach))) {
    return false;
  }
  edge.clip(edge.cut_by(lifted_as<Real>(r.v(2))), 0);
  return edge.ends_certain() && (edge.high().cutter == 0 || edge.low().cutter == 0);
}

// Records whether m cuts off the end that a tetrahedron's fourth ball makes on a dual edge.
template <class Real>
void filter_tetrahedron(Recorder& r, const LiftedInt& m, double reach) {
  using Takes = typename DualEdge<Real>::Takes;
  DualEdge<Real> edge;
  if (!end_by_fourth(r, reach, edge)) return r.add(kFilter<Real>, 0);
  const bool high = edge.high().cutter == 0;
  const auto end = high ? edge.high() : edge.low();
  const double at = high ? end.t : -end.t;
  const auto cut = edge.cut_by(lifted_as<Real>(m));
  const Takes takes = edge.takes(cut);
  int sign = takes == Takes::nothing ? 1 : takes == Takes::all ? -1 : 0;
  if (takes == Takes::some) {
    const bool gone = edge.clip(cut, 1);
    const bool there = (high ? edge.high() : edge.low()).cutter == 0;
    if (edge.ends_certain()) {
      sign = gone || !there ? -1 : edge.certainly_not_empty() ? 1 : 0;
    }
  }
  r.add(kFilter<Real>, sign, 2 * (cut.offset - cut.slope * at),
        2 * (cut.offset_error + cut.slope_error * std::fabs(at) +
             std::fabs(static_cast<double>(cut.slope)) * end.error));
}

// 4 (rho + w) and a little more, which is beyond the orthocentre.
template <int N>
double reach_of(const Orthosphere<N>& sphere, std::int64_t weight) {
  return 4 * std::max(0.0, quotient(sphere.rho()) + static_cast<double>(weight)) + 16;
}

template <int N, class Filters>
void margin_steps(Recorder& r, const BallSet& balls, std::span<const BallIndex> simplex,
                  BallIndex m, const Filters& filters) {
  std::array<BallIndex, N> s;
  std::copy(simplex.begin(), simplex.end(), s.begin());
  const Orthosphere<N> sphere(balls, s);
  const LiftedInt v = lifted_vector(balls, simplex[0], m);
  if (filter_holds<float>(v) && all_within<float>(r, N - 1)) filters(float{}, sphere, v);
  if (!r.decided() && filter_holds<double>(v) && all_within<double>(r, N - 1))
    filters(double{}, sphere, v);
  if (r.decided()) return;
  int sign = 0;
  if constexpr (N == 1) sign = sign_of(v.c);
  if constexpr (N == 2) sign = -edge_foot_cut_exact(r.v(0), v);
  if constexpr (N == 3) sign = -triangle_foot_cut_exact(r.v(0), r.v(1), v);
  if constexpr (N == 4) sign = sphere.side(m);
  r.add(Arithmetic::integers, sign, sphere.excess(m), 0);
  // For equal centres the rule of coincident.hpp decides, not the perturbation.
  const bool twin = std::any_of(simplex.begin(), simplex.end(),
                                [&](BallIndex b) { return balls.centres[b] == balls.centres[m]; });
  if (sign != 0 || twin) return;
  if constexpr (N == 2)
    r.add(Arithmetic::perturbation, edge_tie(r.v(0), v) == EdgeTie::outside ? 1 : -1);
  if constexpr (N == 4) {
    const int cut = orthocentre_cut<WideInt<4>>(r.v(0), r.v(1), EndBall{0, r.v(2)}, v);
    r.add(Arithmetic::perturbation, -cut);
  }
}

template <class Real>
void filter_rho(Recorder& r, std::size_t balls, double radius_square) {
  const auto square = static_cast<Real>(radius_square);
  DualEdge<Real> edge;
  const auto decide = [&] {
    if (balls == 2) return FacetDisc<Real>(lifted_as<Real>(r.v(0)), square).centre_within();
    if (balls == 3) {
      return edge.start(lifted_as<Real>(r.v(0)), lifted_as<Real>(r.v(1)), square)
                 ? edge.foot_within(square)
                 : Decision::out;
    }
    if (!end_by_fourth(r, radius_square, edge)) return Decision::unknown;
    return edge.within(edge.high().cutter == 0 ? edge.high() : edge.low(), square);
  };
  r.add(kFilter<Real>, outside_unless(decide()));
}

template <int N>
void rho_steps(Recorder& r, const LatticeAlpha& alpha) {
  LiftedSimplex<N> s{};
  for (int n = 0; n + 1 < N; ++n) s.v[n] = r.v(n);
  s.weight = r.weight();
  const double radius_square = alpha.plus(s.weight);
  if (N > 1 && radius_square > 0 && all_within<float>(r, N - 1)) {
    filter_rho<float>(r, N, radius_square);
  }
  if (r.decided()) return;
  if (N > 1 && within_bracket_limit(s)) {
    const Bracket rho = rho_bracket(s);
    r.add(Arithmetic::double_filter, compare_bracket(rho, alpha), rho.value - alpha.nearest(),
          rho.error);
  }
  if (r.decided()) return;
  const ExactRho rho = exact_rho(s);
  r.add(Arithmetic::integers, compare_exact(rho, alpha), quotient(rho) - alpha.nearest(), 0);
}

}  // namespace

Steps steps_of_margin(const BallSet& balls, std::span<const BallIndex> simplex, BallIndex m) {
  Recorder r(balls, simplex);
  switch (simplex.size()) {
    case 1:
      margin_steps<1>(r, balls, simplex, m, [](auto, const auto&, const auto&) {});
      break;
    case 2:
      margin_steps<2>(r, balls, simplex, m, [&](auto real, const auto&, const LiftedInt& v) {
        filter_edge<decltype(real)>(r, v);
      });
      break;
    case 3:
      margin_steps<3>(r, balls, simplex, m, [&](auto real, const auto& sphere, const LiftedInt& v) {
        filter_triangle<decltype(real)>(r, v, reach_of(sphere, r.weight()));
      });
      break;
    default:
      margin_steps<4>(r, balls, simplex, m, [&](auto real, const auto& sphere, const LiftedInt& v) {
        filter_tetrahedron<decltype(real)>(r, v, reach_of(sphere, r.weight()));
      });
  }
  return r.take();
}

Steps steps_of_rho(const BallSet& balls, std::span<const BallIndex> simplex,
                   const LatticeAlpha& alpha_on_lattice) {
  Recorder r(balls, simplex);
  switch (simplex.size()) {
    case 1:
      rho_steps<1>(r, alpha_on_lattice);
      break;
    case 2:
      rho_steps<2>(r, alpha_on_lattice);
      break;
    case 3:
      rho_steps<3>(r, alpha_on_lattice);
      break;
    default:
      rho_steps<4>(r, alpha_on_lattice);
  }
  return r.take();
}

}  // namespace alphascope
