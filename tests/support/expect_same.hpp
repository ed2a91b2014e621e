// SPDX-License-Identifier: GPL-3.0-or-later
// Expects two complexes to be the same to the last bit: simplices in order, classes, alpha values,
// hash.
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "core/complex/alpha_complex.hpp"

namespace alphascope::testing {

template <int N>
void expect_same(const SimplexList<N>& a, const SimplexList<N>& b) {
  EXPECT_EQ(a.simplices, b.simplices);
  EXPECT_EQ(a.classes, b.classes);
  ASSERT_EQ(a.alpha_values.size(), b.alpha_values.size());
  if (a.alpha_values.empty()) return;
  EXPECT_EQ(std::memcmp(a.alpha_values.data(), b.alpha_values.data(),
                        a.alpha_values.size() * sizeof(float)),
            0);
}

inline void expect_same(const AlphaComplex& a, const AlphaComplex& b) {
  expect_same(a.vertices, b.vertices);
  expect_same(a.edges, b.edges);
  expect_same(a.triangles, b.triangles);
  expect_same(a.tetrahedra, b.tetrahedra);
  EXPECT_EQ(a.hash, b.hash);
}

}  // namespace alphascope::testing
