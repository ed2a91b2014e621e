// SPDX-License-Identifier: GPL-3.0-or-later
// K_alpha from a regular triangulation that is proven first. It is for alphas at which so many
// balls are near each other that a search among them takes too long. It uses only integers, like
// the whole verifier.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"
#include "core/verify/verify.hpp"
#include "core/verify/verify_balls.hpp"

namespace alphascope {

// All simplices of N balls in the triangulation.
template <int N>
struct ProvenSimplices {
  Simplices<N> simplices;      // in lexicographic order
  std::vector<char> attached;  // is a ball in conflict with its orthosphere?
  std::vector<char> in;        // is it in K_alpha?
};

class ProvenTriangulation {
 public:
  // Makes the triangulation and proves it, in the caller's task arena. Throws Cancelled.
  ProvenTriangulation(const VerifyBalls& balls, const RunContext& context);

  // If this is not ok(), the triangulation is wrong, and the other members are useless.
  const Verification& proof() const { return proof_; }

  template <int N>
  const ProvenSimplices<N>& simplices() const {
    return std::get<N - 1>(levels_);
  }
  // The index of a simplex in its list, or the length of the list if it is not there.
  template <int N>
  std::size_t find(const std::array<BallIndex, N>& simplex) const {
    const Simplices<N>& all = simplices<N>().simplices;
    const auto at = std::lower_bound(all.begin(), all.end(), simplex);
    return at != all.end() && *at == simplex ? static_cast<std::size_t>(at - all.begin())
                                             : all.size();
  }

 private:
  template <int N>
  void mark_cells(const Simplices<N>& cells);
  template <int N>
  void mark_faces();

  const VerifyBalls& balls_;
  const RunContext& context_;
  Verification proof_;
  std::tuple<ProvenSimplices<1>, ProvenSimplices<2>, ProvenSimplices<3>, ProvenSimplices<4>>
      levels_;
};

}  // namespace alphascope
