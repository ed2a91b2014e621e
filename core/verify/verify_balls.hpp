// SPDX-License-Identifier: GPL-3.0-or-later
// The balls that could touch a grown ball: the verifier's own search, in integers. It may find too
// many, never too few. It shares no code with the engines' grid, since it must find the faults of
// that grid.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {

class VerifyBalls {
 public:
  // alpha is any number but NaN, in square lattice units. Keeps a reference to `balls`.
  VerifyBalls(const BallSet& balls, const LatticeAlpha& alpha);
  VerifyBalls(const VerifyBalls&) = delete;
  VerifyBalls& operator=(const VerifyBalls&) = delete;

  const BallSet& balls() const { return balls_; }
  const LatticeAlpha& alpha() const { return alpha_; }
  // A number that no other object of this class has; never 0.
  std::uint64_t number() const { return number_; }

  // Is ball i hidden by a ball with the same centre? Then it is in no simplex.
  bool hidden(BallIndex i) const { return !hidden_.empty() && hidden_[i]; }
  // Is weight + alpha < 0, so that the grown ball has no point?
  bool empty(BallIndex i) const;

  // All other balls that may share a point with i when both are grown, the nearest centre first.
  // Hidden and empty balls are left out.
  void around(BallIndex i, std::vector<BallIndex>& found) const;

  // False only if the two grown balls have no common point. Neither may be empty.
  bool may_touch(BallIndex i, BallIndex m) const;

 private:
  struct Place {
    std::int32_t x, y, z;  // cell
    BallIndex ball;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  Place place_of(BallIndex i) const;

  const BallSet& balls_;
  const std::uint64_t number_;
  LatticeAlpha alpha_;
  std::vector<bool> hidden_;
  bool all_touch_ = false, all_empty_ = false;  // alpha is beyond all distances or weights
  Int128 fixed_alpha_ = 0;                      // alpha in units of 2^-20, rounded up
  LatticePoint low_;
  std::int64_t cell_width_ = 1;  // lattice units; at least the distance of any two that touch
  std::vector<Place> places_;    // sorted
};

}  // namespace alphascope
