// SPDX-License-Identifier: GPL-3.0-or-later
// The verifier's search for near balls. Let a and b be the squared radii of two grown balls with a
// common point. Then the distance of their centres is at most sqrt(a) + sqrt(b), whose square is at
// most 2 (a + b). This is an integer comparison in units of 2^-20. Alpha is rounded up to such a
// unit, so the search may find too many balls. Widths: distances² < 2^62, weights < 2^52 and alpha
// below 2^62 square units, so 2^85 in these units.
#include "core/verify/verify_balls.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/predicates/exact_rho.hpp"

namespace alphascope {
namespace {

constexpr double kBeyondDistances = 4611686018427387904.0;  // 2^62 > 3 (2^30)²
constexpr double kBeyondWeights = 4503599627370496.0;       // 2^52

Int128 fixed(std::int64_t square_units) {
  return Int128{square_units} << 20;
}

// The least width >= 1 whose square is at least 4 a, with a in units of 2^-20. Two balls that touch
// are no farther apart, so their cells differ by at most 1. From 2^31 on there is only one cell.
std::int64_t width_for(Int128 a) {
  constexpr std::int64_t kAll = std::int64_t{1} << 31;
  if (a <= 0) return 1;  // no ball is left, or only points
  const double guess = 2 * std::sqrt(std::ldexp(static_cast<double>(a), -20));
  if (guess >= static_cast<double>(kAll)) return kAll;
  std::int64_t width = std::max(std::int64_t{1}, static_cast<std::int64_t>(guess));
  while (fixed(width * width) < 4 * a) ++width;
  return width;
}

std::uint64_t next_number() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

VerifyBalls::VerifyBalls(const BallSet& balls, const LatticeAlpha& alpha)
    : balls_(balls), number_(next_number()), alpha_(alpha), hidden_(coincident_hidden(balls)) {
  all_touch_ = alpha >= kBeyondDistances;
  all_empty_ = alpha <= -kBeyondWeights;
  if (!all_touch_ && !all_empty_) {
    fixed_alpha_ = static_cast<Int128>(std::ceil(std::ldexp(alpha.above, 20)));
  }
  std::int64_t largest = 0;
  std::vector<BallIndex> alive;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    if (hidden(i) || empty(i)) continue;
    const LatticePoint& p = balls.centres[i];
    if (alive.empty()) low_ = p;
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    largest = std::max(largest, balls.weight(i));
    alive.push_back(i);
  }
  cell_width_ = all_touch_ ? std::int64_t{1} << 31 : width_for(fixed(largest) + fixed_alpha_);
  places_.reserve(alive.size());
  for (const BallIndex i : alive) places_.push_back(place_of(i));
  std::sort(places_.begin(), places_.end());
}

VerifyBalls::Place VerifyBalls::place_of(BallIndex i) const {
  const auto cell = [&](std::int32_t at, std::int32_t low) {
    return static_cast<std::int32_t>((std::int64_t{at} - low) / cell_width_);
  };
  const LatticePoint& p = balls_.centres[i];
  return {cell(p.x, low_.x), cell(p.y, low_.y), cell(p.z, low_.z), i};
}

bool VerifyBalls::empty(BallIndex i) const {
  if (all_touch_ || all_empty_) return all_empty_;
  return compare_exact(exact_vertex_rho(balls_.weight(i)), alpha_) > 0;
}

bool VerifyBalls::may_touch(BallIndex i, BallIndex m) const {
  if (all_touch_) return true;
  const Int128 sum = fixed(balls_.weight(i) + balls_.weight(m)) + 2 * fixed_alpha_;
  return fixed(square_distance(balls_.centres[i], balls_.centres[m])) <= 2 * sum;
}

void VerifyBalls::around(BallIndex i, std::vector<BallIndex>& found) const {
  found.clear();
  if (empty(i)) return;
  const Place at = place_of(i);
  std::vector<std::pair<std::int64_t, BallIndex>> by_distance;
  for (int x = at.x - 1; x <= at.x + 1; ++x) {
    for (int y = at.y - 1; y <= at.y + 1; ++y) {
      auto place = std::lower_bound(places_.begin(), places_.end(), Place{x, y, at.z - 1, 0});
      for (; place != places_.end() && place->x == x && place->y == y && place->z <= at.z + 1;
           ++place) {
        const BallIndex m = place->ball;
        if (m == i || !may_touch(i, m)) continue;
        by_distance.emplace_back(square_distance(balls_.centres[i], balls_.centres[m]), m);
      }
    }
  }
  std::sort(by_distance.begin(), by_distance.end());
  found.reserve(by_distance.size());
  for (const auto& [distance, m] : by_distance) found.push_back(m);
}

}  // namespace alphascope
