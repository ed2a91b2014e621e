// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the device's triangulation has the bytes of CGAL's, and that its certificate finds
// faults.
#include "gpu/wrapping/triangulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "core/triangulation/cgal_triangulation.hpp"
#include "core/wrapping/seed.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using gpu::Uncertified;
using testing::balls_of_file;
using testing::NamedBalls;
using testing::Random;

class GpuTriangulator : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
    triangulator_ = make_gpu_triangulator(seed_tetrahedron);
  }

  void expect_cgal(const BallSet& balls) {
    const Triangulation expected = make_cgal_triangulation(balls, 1);
    const DeviceTriangulation made = triangulator_->make(balls, {});
    if (expected.dimension < 3) {
      EXPECT_FALSE(made.triangulation);
      EXPECT_EQ(made.report.why_not, "the centres of all balls lie in a plane");
      ++flat_;
      return;
    }
    ASSERT_TRUE(made.triangulation) << made.report.why_not;
    EXPECT_TRUE(made.triangulation->tetrahedra == expected.tetrahedra);
    EXPECT_TRUE(made.triangulation->neighbours == expected.neighbours);
    EXPECT_TRUE(made.triangulation->hull == expected.hull);
    EXPECT_TRUE(*made.triangulation == expected);
    hidden_ += expected.hidden.size();
    seeds_ += made.report.known == 1 && expected.tetrahedra.size() > 1;
    wrapped_ += expected.tetrahedra.size() - made.report.known;
  }

  std::unique_ptr<DeviceTriangulator> triangulator_;
  std::size_t flat_ = 0, hidden_ = 0, seeds_ = 0, wrapped_ = 0;
};

TEST_F(GpuTriangulator, HasTheBytesOfCgalForHardSets) {
  Random random(81);
  for (const NamedBalls& set : testing::large_hard_sets(random, 120)) {
    SCOPED_TRACE(set.name);
    expect_cgal(set.balls);
    if (HasFailure()) return;
  }
  EXPECT_GT(hidden_, 10u);
  EXPECT_GT(wrapped_, 1000u);
}

TEST_F(GpuTriangulator, HasTheBytesOfCgalForSmallHardSets) {
  Random random(82);
  for (const NamedBalls& set : testing::small_hard_sets(random, 12)) {
    SCOPED_TRACE(set.name);
    expect_cgal(set.balls);
    if (HasFailure()) return;
  }
  EXPECT_GT(flat_, 5u);
  EXPECT_GT(hidden_, 10u);
}

TEST_F(GpuTriangulator, HasTheBytesOfCgalForAProtein) {
  const BallSet protein = balls_of_file("1crn.xyzr");
  for (const double solvent : {0.0, 1.4, 5.0}) expect_cgal(with_solvent(protein, solvent));
  EXPECT_GT(wrapped_, 500u);
}

// Two clusters at a distance that no small alpha bridges, and four balls as far apart as the
// lattice lets them be.
TEST_F(GpuTriangulator, HasTheBytesOfCgalForFarBalls) {
  Random random(83);
  BallSet clusters = testing::random_balls(random, 150, 400, 100, 300);
  const std::size_t half = clusters.size() / 2;
  for (std::size_t n = 0; n < half; ++n) clusters.centres[n].x += 100'000'000;
  expect_cgal(clusters);
  BallSet far;
  far.lattice.digits = 3;
  constexpr int kFar = 536'000'000;
  for (const int sign : {1, -1}) {
    testing::add_ball(far, sign * kFar, sign * 1000, 0, 1000);
    testing::add_ball(far, 0, sign * kFar, sign * 77, 2000);
    testing::add_ball(far, sign, 0, sign * kFar, 3000);
  }
  expect_cgal(far);
  EXPECT_EQ(seeds_, 1u);
}

TEST_F(GpuTriangulator, MakesTheSameBytesEachTime) {
  const BallSet balls = balls_of_file("1crn.xyzr");
  const DeviceTriangulation first = triangulator_->make(balls, {}),
                            second = triangulator_->make(balls, {});
  ASSERT_TRUE(first.triangulation && second.triangulation);
  EXPECT_TRUE(*first.triangulation == *second.triangulation);
}

TEST_F(GpuTriangulator, IsCancelled) {
  const BallSet balls = balls_of_file("1crn.xyzr");
  RunContext cancelled;
  cancelled.cancel.cancel();
  EXPECT_THROW(triangulator_->make(balls, cancelled), Cancelled);
  expect_cgal(balls);
}

constexpr std::uint32_t kNegative = 1u << 31, kOpen = ~0u;
using Corners = std::array<std::uint32_t, 4>;

Corners without_sign(Corners quad) {
  quad[0] &= ~kNegative;
  return quad;
}

// Makes the neighbours of all faces anew.
void join(Uncertified& all) {
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> open;
  all.neighbours.assign(all.quads.size(), {kOpen, kOpen, kOpen, kOpen});
  for (std::uint32_t t = 0; t < all.quads.size(); ++t) {
    const Corners q = without_sign(all.quads[t]);
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      std::array<std::uint32_t, 3> face;
      for (std::uint32_t k = 0, n = 0; k < 4; ++k) {
        if (k != corner) face[n++] = q[k];
      }
      const auto [at, is_new] = open.try_emplace(face, 4 * t + corner);
      if (is_new) continue;
      all.neighbours[t][corner] = at->second;
      all.neighbours[at->second / 4][at->second % 4] = 4 * t + corner;
      open.erase(at);
    }
  }
}

// Replaces the four tetrahedra around some ball by one. Returns whether there is such a ball.
bool lose_a_ball(Uncertified& all) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> around;
  for (std::uint32_t t = 0; t < all.quads.size(); ++t) {
    for (const std::uint32_t ball : without_sign(all.quads[t])) around[ball].push_back(t);
  }
  for (const auto& [ball, star] : around) {
    const bool inside = std::all_of(star.begin(), star.end(), [&](std::uint32_t t) {
      return std::count(all.neighbours[t].begin(), all.neighbours[t].end(), kOpen) == 0;
    });
    if (star.size() != 4 || !inside) continue;
    const Corners first = without_sign(all.quads[star[0]]);
    std::uint32_t other = 0;  // the ball of the star that the first tetrahedron lacks
    for (const std::uint32_t corner : without_sign(all.quads[star[1]])) {
      if (std::count(first.begin(), first.end(), corner) == 0) other = corner;
    }
    // Each exchange of two corners turns the sign.
    Corners merged = first;
    *std::find(merged.begin(), merged.end(), ball) = other;
    bool negative = (all.quads[star[0]][0] & kNegative) != 0;
    for (int pass = 0; pass < 4; ++pass) {
      for (int k = 0; k < 3; ++k) {
        if (merged[k] < merged[k + 1]) continue;
        std::swap(merged[k], merged[k + 1]);
        negative = !negative;
      }
    }
    merged[0] |= negative ? kNegative : 0;
    std::vector<Corners> kept{merged};
    for (std::uint32_t t = 0; t < all.quads.size(); ++t) {
      if (std::count(star.begin(), star.end(), t) == 0) kept.push_back(all.quads[t]);
    }
    all.quads = kept;
    join(all);
    return true;
  }
  return false;
}

// The message of a certificate for a triangulation that `spoil` changed. Empty if it passed.
std::string message_for(const std::function<void(Uncertified&)>& spoil) {
  Random random(84);
  const BallSet balls = testing::random_balls(random, 200, 400, 20, 200);
  const DeviceTriangulation made =
      gpu::make_spoilt_triangulator(seed_tetrahedron, spoil)->make(balls, {});
  EXPECT_EQ(made.triangulation.has_value(), made.report.why_not.empty());
  return made.report.why_not;
}
bool says(const std::string& message, const char* words) {
  return message.find(words) != std::string::npos;
}

TEST_F(GpuTriangulator, CertifiesWhatIsNotSpoilt) {
  EXPECT_EQ(message_for([](Uncertified& all) { join(all); }), "");
}

TEST_F(GpuTriangulator, FindsALostBall) {
  bool lost = false;
  const std::string message = message_for([&](Uncertified& all) { lost = lose_a_ball(all); });
  EXPECT_TRUE(lost);
  EXPECT_TRUE(says(message, "balls neither in a tetrahedron nor hidden: 1")) << message;
}

TEST_F(GpuTriangulator, FindsWrongNeighbours) {
  const std::string message = message_for([](Uncertified& all) {
    std::swap(all.neighbours[all.quads.size() / 2][1], all.neighbours[all.quads.size() / 3][2]);
  });
  EXPECT_TRUE(says(message, "wrong neighbours")) << message;
}

TEST_F(GpuTriangulator, FindsALostTetrahedron) {
  const std::string message = message_for([](Uncertified& all) {
    const auto inside = std::find_if(all.neighbours.begin(), all.neighbours.end(), [](auto& of) {
      return std::count(of.begin(), of.end(), kOpen) == 0;
    });
    all.quads.erase(all.quads.begin() + (inside - all.neighbours.begin()));
    join(all);
  });
  EXPECT_FALSE(message.empty());
  // Without one at the hull no inner face is wrong, but the hull is not convex.
  const std::string at_hull = message_for([](Uncertified& all) {
    const auto outside = std::find_if(all.neighbours.begin(), all.neighbours.end(), [](auto& of) {
      return std::count(of.begin(), of.end(), kOpen) == 1;
    });
    all.quads.erase(all.quads.begin() + (outside - all.neighbours.begin()));
    join(all);
  });
  EXPECT_TRUE(says(at_hull, "its hull is not convex")) << at_hull;
}

TEST_F(GpuTriangulator, FindsADoubleCover) {
  const std::string one = message_for([](Uncertified& all) {
    all.quads.push_back(all.quads[all.quads.size() / 2]);
    all.neighbours.push_back(all.neighbours[all.quads.size() / 2]);
  });
  EXPECT_TRUE(says(one, "wrong neighbours")) << one;
  // A second copy of everything: each face and each edge is right.
  const std::string whole = message_for([](Uncertified& all) {
    const std::size_t count = all.quads.size();
    for (std::size_t t = 0; t < count; ++t) {
      Corners across = all.neighbours[t];
      for (std::uint32_t& other : across) {
        if (other != kOpen) other += static_cast<std::uint32_t>(4 * count);
      }
      all.quads.push_back(all.quads[t]);
      all.neighbours.push_back(across);
    }
  });
  EXPECT_TRUE(says(whole, "its hull is not convex")) << whole;
}

TEST_F(GpuTriangulator, FindsATurnedTetrahedron) {
  const std::string message =
      message_for([](Uncertified& all) { all.quads[all.quads.size() / 2][0] ^= kNegative; });
  EXPECT_TRUE(says(message, "tetrahedra that are flat or turned: 1")) << message;
}

// The triangulation is the regular one of other weights.
TEST_F(GpuTriangulator, FindsAFaceThatIsNotRegular) {
  Random random(85);
  const BallSet balls = testing::random_balls(random, 200, 400, 20, 200);
  BallSet equal = balls;
  for (auto& radius : equal.radii) radius = 100;
  Uncertified other;
  ASSERT_TRUE(
      gpu::make_spoilt_triangulator(seed_tetrahedron, [&](Uncertified& all) { other = all; })
          ->make(equal, {})
          .triangulation);
  const DeviceTriangulation made =
      gpu::make_spoilt_triangulator(seed_tetrahedron, [&](Uncertified& all) {
        all = other;
      })->make(balls, {});
  EXPECT_TRUE(says(made.report.why_not, "faces that are not regular")) << made.report.why_not;
}

}  // namespace
}  // namespace alphascope
