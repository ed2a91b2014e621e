// SPDX-License-Identifier: GPL-3.0-or-later
// Finds balls whose triangulation has the simplex' true surroundings. First the chosen balls are
// triangulated. Every tetrahedron around the simplex, and every hull facet there, is tested against
// all other balls. Balls that cut one off are chosen too, until there are none.
//
// Correctness: a simplex that the chosen balls cut away is cut away by all balls. No ball cuts off
// anything of the rest around the simplex. So all of the rest is in the triangulation of all balls.
// It surrounds the simplex on all sides, or up to the hull, so nothing else is there.
#include "core/explain/local_star.hpp"

#include <cmath>
#include <numeric>

#include "core/dual_edge/exact_dual_edge.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/verify/verify_orthosphere.hpp"

namespace alphascope {
namespace {

// Relative errors of the sums below are less than 2^-46, far below this. Values nearer to 0 are
// decided in integers.
constexpr double kDoubt = 1.0 / (std::int64_t{1} << 40);

// The ball that cuts off most of a tetrahedron or facet, with its excess; HUGE_VAL: no ball does.
struct Worst {
  double excess = HUGE_VAL;
  BallIndex ball = 0;
  bool found() const { return excess < HUGE_VAL; }
  void add(double value, BallIndex m) {
    if (value < excess) *this = {value, m};
  }
};

class Corner {
 public:
  Corner(const BallSet& balls, const std::array<BallIndex, 4>& t)
      : balls_(balls),
        i_(t[0]),
        j_(lifted_vector(balls, t[0], t[1])),
        k_(lifted_vector(balls, t[0], t[2])),
        l_{0, lifted_vector(balls, t[0], t[3])} {
    const Orthosphere<4> sphere(balls, t);
    x_ = sphere.from_first_ball();
    const ExactRho rho = sphere.rho();
    rho_ = rho.numerator.near_double() / rho.denominator.near_double();
  }

  double rho() const { return rho_; }
  void hold_against(BallIndex m) {
    const LiftedInt v = lifted_vector(balls_, i_, m);
    const double c = static_cast<double>(v.c), x = 2 * static_cast<double>(v.x) * x_.x,
                 y = 2 * static_cast<double>(v.y) * x_.y, z = 2 * static_cast<double>(v.z) * x_.z;
    const double excess = c - x - y - z;
    const double doubt = kDoubt * (std::fabs(c) + std::fabs(x) + std::fabs(y) + std::fabs(z));
    if (excess > doubt || excess >= worst.excess) return;
    if (excess >= -doubt && orthocentre_cut<WideInt<4>>(j_, k_, l_, v) <= 0) return;
    worst.add(excess, m);
  }

  Worst worst;

 private:
  const BallSet& balls_;
  BallIndex i_;
  LiftedInt j_, k_;
  EndBall l_;
  RealPoint x_;  // orthocentre, measured from ball i's centre
  double rho_ = 0;
};

class Outside {
 public:
  // The balls must be counterclockwise when seen from outside.
  Outside(const BallSet& balls, const std::array<BallIndex, 3>& f)
      : balls_(balls),
        i_(f[0]),
        j_(lifted_vector(balls, f[0], f[1])),
        k_(lifted_vector(balls, f[0], f[2])),
        normal_(cross(j_, k_)) {}

  void hold_against(BallIndex m) {
    const LiftedInt v = lifted_vector(balls_, i_, m);
    const double x = static_cast<double>(normal_.x) * static_cast<double>(v.x),
                 y = static_cast<double>(normal_.y) * static_cast<double>(v.y),
                 z = static_cast<double>(normal_.z) * static_cast<double>(v.z);
    const double inside = -(x + y + z),
                 doubt = kDoubt * (std::fabs(x) + std::fabs(y) + std::fabs(z));
    if (inside > doubt || inside >= worst.excess) return;
    if (inside >= -doubt && determinant(j_, k_, v) <= 0) return;
    worst.add(inside, m);
  }

  Worst worst;

 private:
  const BallSet& balls_;
  BallIndex i_;
  LiftedInt j_, k_;
  Vector3<std::int64_t> normal_;
};

template <class Simplex>
bool contains(const Simplex& larger, std::span<const BallIndex> simplex) {
  return std::all_of(simplex.begin(), simplex.end(), [&](BallIndex v) {
    return std::find(larger.begin(), larger.end(), v) != larger.end();
  });
}

// The tetrahedra and hull facets around the simplex, which are tested against all balls.
struct Boundary {
  std::vector<Corner> corners;
  std::vector<Outside> outside;

  Boundary(const BallSet& balls, std::span<const BallIndex> simplex, const LocalStar& star) {
    std::vector<BallIndex> local;
    for (const BallIndex v : simplex) local.push_back(star.local(v));
    const auto global = [&](const auto& s) {
      auto result = s;
      for (BallIndex& v : result) v = star.chosen[v];
      return result;
    };
    for (const auto& t : star.triangulation.tetrahedra) {
      if (contains(t, local)) corners.emplace_back(balls, global(t));
    }
    for (const HullFacet& facet : star.triangulation.hull) {
      if (contains(facet.balls, local)) outside.emplace_back(balls, global(facet.balls));
    }
  }

  // The square of a distance from the first ball's centre beyond which no ball cuts off a corner. A
  // ball that cuts off a corner has at most power rho there, and so has the first ball. So both
  // contain the corner when grown by the largest rho, and their centres are no farther apart than
  // the root of the result.
  double reach_square(std::int64_t weight, std::int64_t other_weight) const {
    double rho = -HUGE_VAL;
    for (const Corner& corner : corners) rho = std::max(rho, corner.rho());
    const double grown = rho + 1e-9 * std::fabs(rho) + 1;
    return 2 *
           (std::max(0.0, static_cast<double>(weight) + grown) +
            std::max(0.0, static_cast<double>(other_weight) + grown)) *
           (1 + 1e-9);
  }
};

// For each tetrahedron or facet around the simplex that some ball cuts off, the ball that cuts off
// most of it.
std::vector<BallIndex> cutters(const BallSet& balls, std::span<const BallIndex> simplex,
                               const LocalStar& star, const CancelToken& cancel) {
  Boundary boundary(balls, simplex, star);
  if (boundary.corners.empty()) return {};  // the chosen balls cut the simplex away
  const BallIndex i = simplex[0];
  const RealPoint p = real_point(balls.centres[i]);
  const std::int64_t largest =
      boundary.outside.empty() ? *std::max_element(balls.radii.begin(), balls.radii.end()) : 0;
  const double reach = boundary.outside.empty()
                           ? boundary.reach_square(balls.weight(i), largest * largest)
                           : HUGE_VAL;
  for (BallIndex m = 0; m < balls.size(); ++m) {
    if (m % 65536 == 0) cancel.throw_if_cancelled();
    const RealPoint d = real_point(balls.centres[m]) - p;
    if (dot(d, d) > reach || std::binary_search(star.chosen.begin(), star.chosen.end(), m))
      continue;
    for (Corner& corner : boundary.corners) corner.hold_against(m);
    for (Outside& facet : boundary.outside) facet.hold_against(m);
  }
  std::vector<BallIndex> found;
  for (const Corner& corner : boundary.corners) {
    if (corner.worst.found()) found.push_back(corner.worst.ball);
  }
  for (const Outside& facet : boundary.outside) {
    if (facet.worst.found()) found.push_back(facet.worst.ball);
  }
  return found;
}

void make(const BallSet& balls, LocalStar& star, const RunContext& context) {
  std::sort(star.chosen.begin(), star.chosen.end());
  star.chosen.erase(std::unique(star.chosen.begin(), star.chosen.end()), star.chosen.end());
  auto local = std::make_shared<BallSet>();
  local->lattice = balls.lattice;
  for (const BallIndex v : star.chosen) {
    local->centres.push_back(balls.centres[v]);
    local->radii.push_back(balls.radii[v]);
  }
  star.triangulation = make_triangulation(*local, 1, context);
  star.balls = std::move(local);
}

}  // namespace

LocalStar local_star(const BallSet& balls, std::span<const BallIndex> simplex,
                     std::vector<BallIndex> first, const RunContext& context) {
  LocalStar star;
  star.chosen = std::move(first);
  const std::vector<BallIndex> span = spanning_balls(balls, simplex[0]);
  star.chosen.insert(star.chosen.end(), span.begin(), span.end());
  // If all balls are in one plane or on one line, all are chosen.
  if (span.size() < 4) {
    star.chosen.resize(balls.size());
    std::iota(star.chosen.begin(), star.chosen.end(), BallIndex{0});
  }
  for (;;) {
    make(balls, star, context);
    if (star.chosen.size() == balls.size()) return star;
    const std::vector<BallIndex> more = cutters(balls, simplex, star, context.cancel);
    if (more.empty()) return star;
    star.chosen.insert(star.chosen.end(), more.begin(), more.end());
  }
}

}  // namespace alphascope
