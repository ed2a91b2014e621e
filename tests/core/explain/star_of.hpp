// SPDX-License-Identifier: GPL-3.0-or-later
// Expects the steps of a ball to end in its star, the simplices that contain it.
#pragma once

#include <algorithm>

#include "core/explain/ball_steps.hpp"
#include "tests/support/expect_same.hpp"

namespace alphascope::testing {

template <int N>
SimplexList<N> with_ball(const SimplexList<N>& list, BallIndex ball) {
  SimplexList<N> star;
  for (std::size_t n = 0; n < list.size(); ++n) {
    const auto& s = list.simplices[n];
    if (std::find(s.begin(), s.end(), ball) == s.end()) continue;
    star.simplices.push_back(s);
    star.alpha_values.push_back(list.alpha_values[n]);
    star.classes.push_back(list.classes[n]);
  }
  return star;
}

inline void expect_star(const BallSteps& steps, const AlphaComplex& whole) {
  expect_same(steps.star.vertices, with_ball(whole.vertices, steps.ball));
  expect_same(steps.star.edges, with_ball(whole.edges, steps.ball));
  expect_same(steps.star.triangles, with_ball(whole.triangles, steps.ball));
  expect_same(steps.star.tetrahedra, with_ball(whole.tetrahedra, steps.ball));
}

}  // namespace alphascope::testing
