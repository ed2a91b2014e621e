// SPDX-License-Identifier: GPL-3.0-or-later
// Tests groups of simplices with a common face.
#include "core/complex/face_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace alphascope {
namespace {

// Distinct simplices of M vertices, in order. Some vertices are in none of them.
template <int M>
Simplices<M> random_simplices(std::mt19937& engine, std::size_t count, BallIndex vertices) {
  std::uniform_int_distribution<BallIndex> vertex(3, vertices);
  Simplices<M> list;
  while (list.size() < count) {
    std::array<BallIndex, M> simplex;
    for (BallIndex& v : simplex) v = vertex(engine);
    std::sort(simplex.begin(), simplex.end());
    if (std::adjacent_find(simplex.begin(), simplex.end()) == simplex.end()) {
      list.push_back(simplex);
    }
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

template <int N>
using Cofaces = std::map<std::array<BallIndex, N>, std::vector<std::uint32_t>>;

template <int N>
Cofaces<N> by_definition(const Simplices<N + 1>& list) {
  Cofaces<N> cofaces;
  for (std::uint32_t c = 0; c < list.size(); ++c) {
    for (std::size_t dropped = 0; dropped <= N; ++dropped) {
      std::array<BallIndex, N> face;
      for (std::size_t n = 0; n < N; ++n) face[n] = list[c][n < dropped ? n : n + 1];
      cofaces[face].push_back(c);
    }
  }
  return cofaces;
}

// Adds the contents of these groups, which must follow all that is there.
template <int N>
void add(const FaceGroups<N>& groups, Cofaces<N>& found) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    EXPECT_TRUE(found.empty() || found.rbegin()->first < groups.faces()[g]);
    std::vector<std::uint32_t>& cofaces = found[groups.faces()[g]];
    groups.for_cofaces(g, [&](std::uint32_t c) { cofaces.push_back(c); });
    EXPECT_EQ(groups.coface_count(g), cofaces.size());
  }
}

template <int N>
void expect_all_faces(const Simplices<N + 1>& list) {
  const Cofaces<N> expected = by_definition<N>(list);
  Cofaces<N> found;
  add<N>(FaceGroups<N>(list), found);
  EXPECT_EQ(found, expected);
  for (const std::size_t at_a_time : {1, 2, 7, 100, 1 << 16}) {
    std::size_t times = 0;
    found.clear();
    for_face_groups<N>(
        list, {},
        [&](const FaceGroups<N>& groups) {
          ++times;
          add<N>(groups, found);
        },
        at_a_time);
    EXPECT_EQ(found, expected) << at_a_time << " at a time";
    if (at_a_time > 2 * list.size()) {
      EXPECT_EQ(times, list.empty() ? 0 : 1);
    }
    if (at_a_time == 1 && list.size() > 10) {
      EXPECT_GT(times, 3);
    }
  }
}

TEST(FaceGroups, HaveAllCofacesOfEveryFaceHoweverManyAtATime) {
  std::mt19937 engine(71);
  for (const std::size_t count : {0, 1, 2, 30, 500}) {
    for (const BallIndex vertices : {8, 12, 40}) {
      if (count > 30 && vertices < 40) continue;  // there are not so many
      expect_all_faces<3>(random_simplices<4>(engine, count, vertices));
      expect_all_faces<2>(random_simplices<3>(engine, count, vertices));
      expect_all_faces<1>(random_simplices<2>(engine, count, vertices));
    }
  }
}

// The verifier may have lists that are not sorted.
TEST(FaceGroups, NeedNoOrderOfTheSimplices) {
  std::mt19937 engine(72);
  Simplices<4> list = random_simplices<4>(engine, 200, 30);
  std::shuffle(list.begin(), list.end(), engine);
  expect_all_faces<3>(list);
}

}  // namespace
}  // namespace alphascope
