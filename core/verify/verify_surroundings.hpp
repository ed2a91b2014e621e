// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the balls near a simplex, and those in conflict with its orthosphere. Each thread has an
// object of its own, which keeps memory between calls.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "core/verify/verify_balls.hpp"
#include "core/verify/verify_orthosphere.hpp"

namespace alphascope {

class Surroundings {
 public:
  // Finds all other balls that may touch every ball of a simplex.
  template <int N>
  void find_near_balls(const VerifyBalls& balls, const std::array<BallIndex, N>& simplex) {
    if (balls_ != balls.number() || first_ != simplex[0]) {  // rarely true, since lists are sorted
      balls.around(simplex[0], around_first_);
      balls_ = balls.number();
      first_ = simplex[0];
    }
    near_.clear();
    std::copy_if(around_first_.begin(), around_first_.end(), std::back_inserter(near_),
                 [&](BallIndex m) {
                   return std::all_of(simplex.begin() + 1, simplex.end(),
                                      [&](BallIndex v) { return v != m && balls.may_touch(v, m); });
                 });
  }
  const std::vector<BallIndex>& near() const { return near_; }
  const std::vector<BallIndex>& ties() const { return ties_; }

  // Is a near ball in conflict with the orthosphere of `simplex`? The simplex may have more balls
  // than the one given to find_near_balls(). If there is no conflict, ties() are the near balls of
  // power rho at the orthocentre.
  template <int N>
  bool conflict(const Orthosphere<N>& sphere, const std::array<BallIndex, N>& simplex) {
    ties_.clear();
    const auto cuts = [&](BallIndex m) {
      if (std::find(simplex.begin(), simplex.end(), m) != simplex.end()) return false;
      const int side = sphere.side(m);
      if (side == 0) ties_.push_back(m);
      return side < 0;
    };
    // A ball in conflict with one simplex is often in conflict with the next.
    if (culprit_ < near_.size() && cuts(near_[culprit_])) return true;
    ties_.clear();
    for (culprit_ = 0; culprit_ < near_.size(); ++culprit_) {
      if (cuts(near_[culprit_])) return true;
    }
    return false;
  }

 private:
  std::uint64_t balls_ = 0;  // number() of the VerifyBalls for the next two members
  BallIndex first_ = 0;
  std::vector<BallIndex> around_first_;
  std::vector<BallIndex> near_, ties_;
  std::size_t culprit_ = 0;
};

}  // namespace alphascope
