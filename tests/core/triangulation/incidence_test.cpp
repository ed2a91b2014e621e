// SPDX-License-Identifier: GPL-3.0-or-later
// Tests triangles and edges of a triangulation against a sort of all faces.
#include "core/triangulation/incidence.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/complex/face_groups.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;

std::vector<NamedBalls> sets() {
  Random random(71);
  std::vector<NamedBalls> sets = testing::large_hard_sets(random);
  for (NamedBalls& set : testing::small_hard_sets(random, 9)) sets.push_back(std::move(set));
  sets.push_back({"many", testing::random_balls(random, 2000, 2000, 20, 200)});
  return sets;
}

template <std::size_t N>
std::array<BallIndex, N - 1> without(const std::array<BallIndex, N>& simplex, std::size_t k) {
  std::array<BallIndex, N - 1> face;
  for (std::size_t n = 0, at = 0; n < N; ++n) {
    if (n != k) face[at++] = simplex[n];
  }
  return face;
}

TEST(Incidence, IsThatOfTheFacesOfAllTetrahedra) {
  std::size_t solid = 0;
  for (const NamedBalls& set : sets()) {
    const Triangulation triangulation = make_triangulation(set.balls, 1);
    const Incidence incidence = make_incidence(triangulation);
    if (triangulation.dimension < 3) {
      EXPECT_EQ(incidence, Incidence()) << set.name;
      continue;
    }
    ++solid;
    const FaceGroups<3> triangles(triangulation.tetrahedra);
    const FaceGroups<2> edges(triangles.faces());
    ASSERT_EQ(incidence.triangles, triangles.faces()) << set.name;
    ASSERT_EQ(incidence.edges, edges.faces()) << set.name;
    for (std::size_t f = 0; f < incidence.triangles.size(); ++f) {
      std::vector<std::uint32_t> cofaces;
      triangles.for_cofaces(f, [&](std::uint32_t t) { cofaces.push_back(t); });
      cofaces.resize(2, Incidence::kOutside);
      ASSERT_TRUE(
          std::equal(cofaces.begin(), cofaces.end(), incidence.tetrahedra_of_triangle[f].begin()));
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(incidence.edges[incidence.edges_of_triangle[f][k]],
                  without(incidence.triangles[f], k));
      }
    }
    for (std::size_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
      const auto& balls = triangulation.tetrahedra[t];
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_EQ(incidence.triangles[incidence.triangles_of_tetrahedron[t][k]], without(balls, k));
        for (std::size_t l = k + 1; l < 4; ++l) {
          ASSERT_EQ(incidence.edges[edge_of_tetrahedron(incidence, t, k, l)],
                    (std::array{balls[k], balls[l]}));
        }
      }
    }
  }
  EXPECT_GT(solid, 20u);
}

TEST(Incidence, IsTheSameForAnyNumberOfThreads) {
  Random random(72);
  const Triangulation triangulation =
      make_triangulation(testing::random_balls(random, 5000, 3000, 20, 200), 1);
  const Incidence alone = tbb::task_arena(1).execute([&] { return make_incidence(triangulation); });
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(tbb::task_arena(threads).execute([&] { return make_incidence(triangulation); }),
              alone);
  }
}

TEST(Incidence, IsCancelled) {
  Random random(73);
  const Triangulation triangulation =
      make_triangulation(testing::random_balls(random, 100, 300, 20, 200), 1);
  const CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(make_incidence(triangulation, cancel), Cancelled);
}

}  // namespace
}  // namespace alphascope
