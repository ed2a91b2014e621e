// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the hash of a complex, and the memory of its arrays.
#include "core/complex/alpha_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/complex/face_code.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

// A tetrahedron and some of its faces.
AlphaComplex some_faces() {
  AlphaComplex complex;
  complex.vertices.simplices = {{0}, {1}, {2}, {3}};
  complex.edges.simplices = {{0, 1}, {1, 2}, {0, 3}};
  complex.triangles.simplices = {{0, 1, 2}, {1, 2, 3}};
  complex.tetrahedra.simplices = {{0, 1, 2, 3}};
  return complex;
}

// Numbers from an independent implementation of the definition in simplex_hash.hpp.
TEST(ComplexHash, IsTheSumOfItsSimplices) {
  AlphaComplex complex = some_faces();
  EXPECT_EQ(hash_text(complex_hash(complex)), "042b455a898b9f86");
  EXPECT_EQ(hash_text(tetrahedra_hash(complex)), "7d83d0796d976717");
  std::reverse(complex.edges.simplices.begin(), complex.edges.simplices.end());
  EXPECT_EQ(hash_text(complex_hash(complex)), "042b455a898b9f86") << "in any order";
  complex.tetrahedra_only = true;
  EXPECT_EQ(hash_text(complex_hash(complex)), "7d83d0796d976717");
}

TEST(ComplexHash, DependsOnEveryDimension) {
  const std::uint64_t whole = complex_hash(some_faces());
  AlphaComplex one_less = some_faces();
  one_less.vertices.simplices.resize(3);
  EXPECT_NE(complex_hash(one_less), whole);
  one_less = some_faces();
  one_less.edges.simplices.resize(2);
  EXPECT_NE(complex_hash(one_less), whole);
  one_less = some_faces();
  one_less.triangles.simplices.resize(1);
  EXPECT_NE(complex_hash(one_less), whole);
  one_less = some_faces();
  one_less.tetrahedra.simplices.resize(0);
  EXPECT_NE(complex_hash(one_less), whole);
}

// Many simplices are summed by several threads.
TEST(ComplexHash, OfManyIsTheSameAsOfAsManyParts) {
  AlphaComplex complex;
  std::uint64_t sum = 0;
  for (BallIndex v = 0; v < 100'000; ++v) {
    complex.tetrahedra.simplices.push_back({v, v + 1, v + 2, v + 3});
    sum += simplex_hash<4>(complex.tetrahedra.simplices.back().data());
  }
  HashSums sums;
  sums.sum[3] = sum;
  sums.count[3] = 100'000;
  EXPECT_EQ(tetrahedra_hash(complex), sums.combined(true));
}

TEST(ComplexBytes, AreThoseOfAllItsArrays) {
  AlphaComplex complex = some_faces();
  const auto fit = [](auto& list) {
    list.alpha_values = ResultArray<float>(list.size(), 1.0f);
    list.classes = ResultArray<SimplexClass>(list.size(), SimplexClass::interior);
    list.simplices.shrink_to_fit();
  };
  fit(complex.vertices);
  fit(complex.edges);
  fit(complex.triangles);
  fit(complex.tetrahedra);
  // 4 vertices, 3 edges, 2 triangles, 1 tetrahedron of 4 bytes a corner, 10 values and classes.
  const std::uint64_t arrays =
      4 * (4 * 1 + 3 * 2 + 2 * 3 + 1 * 4) + 10 * (4 + sizeof(SimplexClass));
  EXPECT_EQ(bytes_of(complex), arrays);
  std::array<FaceCode, 5> faces{};
  complex.outside = SharedFaces{nullptr, faces};
  EXPECT_EQ(bytes_of(complex), arrays + 5 * sizeof(FaceCode));
}

}  // namespace
}  // namespace alphascope
