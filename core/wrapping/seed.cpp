// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the largest ball, which is never hidden, and the balls whose radical planes are nearest to
// its centre. A tetrahedron of their triangulation is one of all balls' if no ball is in conflict
// with it. Else the ball in deepest conflict is taken, too.
#include "core/wrapping/seed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/wrapping/conflict.hpp"
#include "core/wrapping/crossing.hpp"

namespace alphascope {
namespace {

IndexedBall indexed_ball(const BallSet& balls, BallIndex i) {
  const LatticePoint& p = balls.centres[i];
  return {p.x, p.y, p.z, balls.radii[i], i};
}

// Tells by doubles which balls certainly stay out of the orthosphere of a tetrahedron.
class RoughSphere {
 public:
  RoughSphere(const BallSet& balls, const std::array<BallIndex, 4>& t)
      : balls_(balls), first_(t[0]) {
    const LiftedInt j = lifted_vector(balls, t[0], t[1]), k = lifted_vector(balls, t[0], t[2]),
                    l = lifted_vector(balls, t[0], t[3]);
    usable_ = face_.set(lifted_as<double>(j), lifted_as<double>(k), orientation(j, k, l));
    if (!usable_) return;
    behind_ = face_.turned();
    own_ = face_.crossing(rough(t[3]));
    const double s = (face_.side() > 0 ? 0.5 : -0.5) * (own_.low + own_.high);
    const auto &foot = face_.line().foot(), &n = face_.line().direction();
    centre_ = {foot.x + s * n.x, foot.y + s * n.y, foot.z + s * n.z};
  }
  // With the last ball before the face of the others: a ball before that face has to touch later,
  // and a ball behind it earlier.
  bool surely_out(BallIndex m) const {
    if (!usable_) return false;
    const RoughLifted<double> v = rough(m);
    if (v.v.x == 0 && v.v.y == 0 && v.v.z == 0) return false;  // on both sides of every face
    const Crossing<double> before = face_.crossing(v), behind = behind_.crossing(v);
    return (before.none() || before.low > own_.high) && (behind.none() || -behind.low < own_.low);
  }

  // The power of a ball at the orthocentre beyond that of the corners, rounded.
  double excess(BallIndex m) const {
    const auto v = rough(m).v;
    return v.c - 2 * (v.x * centre_.x + v.y * centre_.y + v.z * centre_.z);
  }

 private:
  RoughLifted<double> rough(BallIndex m) const {
    const LatticePoint &p = balls_.centres[first_], &q = balls_.centres[m];
    return rough_lifted<double>(q.x - p.x, q.y - p.y, q.z - p.z,
                                static_cast<double>(balls_.weight(first_) - balls_.weight(m)));
  }

  const BallSet& balls_;
  BallIndex first_;
  bool usable_ = false;
  OpenFace<double> face_, behind_;
  Crossing<double> own_{};
  Vector3<double> centre_{};
};

// The ball in deepest conflict with a tetrahedron, or kNone. Rounding changes only the choice among
// several.
constexpr BallIndex kNone = std::numeric_limits<BallIndex>::max();
BallIndex conflict(const BallSet& balls, const std::array<BallIndex, 4>& tetrahedron,
                   const CancelToken& cancel) {
  IndexedBall corners[4];
  for (int c = 0; c < 4; ++c) corners[c] = indexed_ball(balls, tetrahedron[c]);
  const RoughSphere sphere(balls, tetrahedron);
  std::mutex mutex;
  std::pair<double, BallIndex> deepest{0, kNone};
  constexpr std::size_t kGrain = 4096;
  parallel_ranges(BallIndex{0}, static_cast<BallIndex>(balls.size()), kGrain,
                  [&](BallIndex begin, BallIndex end) {
                    std::pair<double, BallIndex> own{0, kNone};
                    for (BallIndex m = begin; m < end && !cancel.cancelled(); ++m) {
                      if (sphere.surely_out(m)) continue;
                      const bool corner =
                          std::find(tetrahedron.begin(), tetrahedron.end(), m) != tetrahedron.end();
                      if (corner || stays_out(corners, indexed_ball(balls, m))) continue;
                      const std::pair<double, BallIndex> found{sphere.excess(m), m};
                      if (own.second == kNone || found < own) own = found;
                    }
                    if (own.second == kNone) return;
                    const std::lock_guard lock(mutex);
                    if (deepest.second == kNone || own < deepest) deepest = own;
                  });
  cancel.throw_if_cancelled();
  return deepest.second;
}

// The 64 balls whose radical planes with ball `top` are nearest to its centre, or all others if
// there are fewer. By the distance of the plane, c / (2 |d|); its rounding changes only the choice.
std::vector<BallIndex> nearest_balls(const BallSet& balls, BallIndex top) {
  constexpr std::ptrdiff_t kNearest = 64;
  using Planes = std::vector<std::pair<double, BallIndex>>;
  const auto keep_nearest = [](Planes& planes) {
    if (std::ssize(planes) <= kNearest) return;
    std::nth_element(planes.begin(), planes.begin() + (kNearest - 1), planes.end());
    planes.resize(kNearest);
  };
  std::mutex mutex;
  Planes nearest;
  constexpr std::size_t kGrain = 1 << 14;
  parallel_ranges(BallIndex{0}, static_cast<BallIndex>(balls.size()), kGrain,
                  [&](BallIndex begin, BallIndex end) {
                    Planes own;
                    own.reserve(end - begin);
                    for (BallIndex m = begin; m < end; ++m) {
                      const LiftedInt v = lifted_vector(balls, top, m);
                      const auto x = static_cast<double>(v.x), y = static_cast<double>(v.y),
                                 z = static_cast<double>(v.z), square = x * x + y * y + z * z;
                      if (square > 0)
                        own.emplace_back(static_cast<double>(v.c) / std::sqrt(square), m);
                    }
                    keep_nearest(own);
                    const std::lock_guard lock(mutex);
                    nearest.insert(nearest.end(), own.begin(), own.end());
                  });
  keep_nearest(nearest);
  std::vector<BallIndex> result;
  for (const auto& [distance, m] : nearest) result.push_back(m);
  return result;
}

}  // namespace

std::optional<std::array<BallIndex, 4>> seed_tetrahedron(const BallSet& balls,
                                                         const CancelToken& cancel) {
  if (balls.size() < 4) return std::nullopt;
  const auto largest = std::max_element(balls.radii.begin(), balls.radii.end());
  const auto top = static_cast<BallIndex>(largest - balls.radii.begin());
  std::vector<BallIndex> taken = spanning_balls(balls, top);
  if (taken.size() < 4) return std::nullopt;

  for (const BallIndex m : nearest_balls(balls, top)) taken.push_back(m);
  // Each pass takes at least one ball more. So this ends, at the latest with all of them.
  for (;;) {
    std::sort(taken.begin(), taken.end());
    taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
    BallSet few{balls.lattice, {}, {}};
    for (const BallIndex i : taken) {
      few.centres.push_back(balls.centres[i]);
      few.radii.push_back(balls.radii[i]);
    }
    const Triangulation part = make_cgal_triangulation(few, 1, {cancel, {}});
    std::vector<std::array<BallIndex, 4>> around;
    for (const auto& t : part.tetrahedra) {
      std::array<BallIndex, 4> own;
      for (int c = 0; c < 4; ++c) own[c] = taken[t[c]];
      if (std::find(own.begin(), own.end(), top) != own.end()) around.push_back(own);
    }
    // The smallest are the likeliest. Distances are rounded, which changes only the order.
    const auto size = [&](const std::array<BallIndex, 4>& t) {
      double most = 0;
      for (const BallIndex m : t) {
        const LiftedInt v = lifted_vector(balls, top, m);
        most = std::max(most, static_cast<double>(v.c));
      }
      return most;
    };
    std::sort(around.begin(), around.end(), [&](const auto& a, const auto& b) {
      return std::pair(size(a), a) < std::pair(size(b), b);
    });
    constexpr std::size_t kTried = 4;
    for (std::size_t n = 0; n < around.size() && n < kTried; ++n) {
      const BallIndex m = conflict(balls, around[n], cancel);
      if (m == kNone) return around[n];
      taken.push_back(m);
    }
  }
}

}  // namespace alphascope
