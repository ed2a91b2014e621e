// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the bounds of crossings agree with integers, up to the limits of the lattice.
#include "core/wrapping/crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/geometry/lattice_point.hpp"

namespace alphascope {
namespace {

struct Ball {
  LatticePoint centre;
  std::int32_t radius;
};

class Face {
 public:
  Face(const Ball& i, const Ball& j, const Ball& k, int side)
      : i_(i), j_(lifted(j)), k_(lifted(k)), side_(side) {}

  LiftedInt lifted(const Ball& m) const {
    return lifted_vector(i_.centre, i_.radius, m.centre, m.radius);
  }
  bool is_in_front(const Ball& m) const { return sign_of(determinant(j_, k_, lifted(m))) == side_; }
  bool touches_before(const Ball& l, const Ball& m) const {
    return alphascope::touches_before(j_, k_, lifted(l), lifted(m));
  }
  // False if Real cannot represent the face.
  template <class Real>
  bool set(OpenFace<Real>& face, Real scale) const {
    const auto exact = [](const LiftedInt& v) {
      constexpr std::int64_t most = std::int64_t{1} << (sizeof(Real) == 4 ? 24 : 53);
      return std::abs(v.x) < most && std::abs(v.y) < most && std::abs(v.z) < most;
    };
    const auto scaled = [&](const LiftedInt& v) {
      return LiftedVector<Real>{static_cast<Real>(v.x) * scale, static_cast<Real>(v.y) * scale,
                                static_cast<Real>(v.z) * scale,
                                static_cast<Real>(v.c) * scale * scale};
    };
    return exact(j_) && exact(k_) && face.set(scaled(j_), scaled(k_), side_);
  }
  template <class Real>
  Crossing<Real> crossing(const OpenFace<Real>& face, Real scale, const Ball& m) const {
    const LiftedInt v = lifted(m);
    const Real weights = static_cast<Real>(i_.radius - m.radius) * scale *
                         (static_cast<Real>(i_.radius + m.radius) * scale);
    return face.crossing(rough_lifted(static_cast<Real>(v.x) * scale,
                                      static_cast<Real>(v.y) * scale,
                                      static_cast<Real>(v.z) * scale, weights));
  }

 private:
  Ball i_;
  LiftedInt j_, k_;
  int side_;
};

struct Count {
  int in_front = 0, decided = 0, compared = 0;
};

// A lattice point near the plane of three points, with coordinates from `least` to `most`.
LatticePoint near_plane(const LatticePoint& from, const LatticePoint& a, const LatticePoint& b,
                        std::mt19937& random, std::int32_t least, std::int32_t most) {
  std::uniform_real_distribution<double> share(-1, 2);
  std::uniform_int_distribution<int> beside(-1, 1);
  const double s = share(random), t = share(random);
  const auto place = [&](std::int32_t o, std::int32_t p, std::int32_t q) {
    const double at = o + s * (static_cast<double>(p) - o) + t * (static_cast<double>(q) - o);
    return static_cast<std::int32_t>(std::clamp(
        std::round(at) + beside(random), static_cast<double>(least), static_cast<double>(most)));
  };
  return {place(from.x, a.x, b.x), place(from.y, a.y, b.y), place(from.z, a.z, b.z)};
}

// Five balls within `extent` of each other, and the crossings of the last two with a face of three.
template <class Real>
Count agree(std::uint32_t seed, std::int32_t extent, std::int32_t most_radius, int tries) {
  std::mt19937 random(seed);
  const std::int32_t from = extent < kMaxLatticeCoordinate / 2 ? 1000 : -kMaxLatticeCoordinate;
  std::uniform_int_distribution<std::int32_t> at(from, from + extent), radius(1, most_radius);
  const auto scale =
      static_cast<Real>(std::ldexp(1.0, 12 - static_cast<int>(std::log2(extent)) - 1));
  Count count;
  for (int n = 0; n < tries; ++n) {
    std::array<Ball, 5> balls;
    for (Ball& ball : balls) ball = {{at(random), at(random), at(random)}, radius(random)};
    const auto close = [&](std::size_t m) {
      balls[m].centre = near_plane(balls[0].centre, balls[1].centre, balls[2].centre, random, from,
                                   from + extent);
    };
    if (n % 3 == 1) balls[2].centre = balls[1].centre;  // nearly collinear, after this
    if (n % 3 == 1) close(2);
    if (n % 5 >= 3) close(3);
    if (n % 5 == 4) close(4);
    if (n % 4 == 1) balls[4].centre = balls[3].centre;
    if (n % 4 == 2) balls[4] = balls[3];  // the same crossing, and one unit beside it
    if (n % 8 == 2) balls[4].centre.x += balls[4].centre.x < from + extent ? 1 : -1;
    const Face face(balls[0], balls[1], balls[2], n % 2 == 0 ? 1 : -1);
    OpenFace<Real> open;
    if (!face.set(open, scale)) continue;
    std::array<Crossing<Real>, 2> crossings;
    for (std::size_t b = 0; b < 2; ++b) {
      const Ball& ball = balls[3 + b];
      crossings[b] = face.crossing(open, scale, ball);
      const bool in_front = face.is_in_front(ball);
      count.in_front += in_front ? 1 : 0;
      EXPECT_FALSE(crossings[b].none() && in_front) << n;
      if (crossings[b].high < Crossing<Real>::kNever) {
        EXPECT_TRUE(in_front) << n;
        ++count.decided;
      }
    }
    if (!face.is_in_front(balls[3]) || !face.is_in_front(balls[4])) continue;
    const bool first = face.touches_before(balls[4], balls[3]),
               second = face.touches_before(balls[3], balls[4]);
    const bool same = balls[3].centre == balls[4].centre && balls[3].radius == balls[4].radius;
    EXPECT_EQ(first || second, !same) << n;
    EXPECT_FALSE(first && second) << n;
    EXPECT_TRUE(balls[3].centre != balls[4].centre || first == (balls[3].radius > balls[4].radius))
        << n;
    const bool says_first = crossings[0].high < crossings[1].low,
               says_second = crossings[1].high < crossings[0].low;
    EXPECT_TRUE(!says_first || first) << n;
    EXPECT_TRUE(!says_second || second) << n;
    count.compared += says_first || says_second ? 1 : 0;
    if (::testing::Test::HasFailure()) return count;
  }
  return count;
}

constexpr int kTries = 40000;

TEST(Crossing, OfSmallSetsAgreesWithIntegers) {
  for (const std::int32_t extent : {3, 20, 1000, 50000}) {
    SCOPED_TRACE(extent);
    const Count single = agree<float>(1, extent, extent, kTries),
                both = agree<double>(2, extent, extent, kTries);
    EXPECT_GT(single.decided, single.in_front / 4);
    EXPECT_GT(both.decided, both.in_front * 9 / 10);
    EXPECT_GT(single.compared, kTries / 100);
    EXPECT_GT(both.compared, kTries / 100);
  }
}

TEST(Crossing, AtTheBoundsOfTheLatticeAgreesWithIntegers) {
  constexpr std::int32_t kWhole = 2 * kMaxLatticeCoordinate;
  for (const std::int32_t radius : {1, kMaxLatticeRadius}) {
    SCOPED_TRACE(radius);
    EXPECT_EQ(agree<float>(3, kWhole, radius, 1000).decided, 0) << "faces beyond single precision";
    const Count both = agree<double>(4, kWhole, radius, kTries);
    EXPECT_GT(both.decided, both.in_front * 9 / 10);
    EXPECT_GT(both.compared, kTries / 10);
    const Count single = agree<float>(5, (1 << 24) - 1, radius, kTries);
    EXPECT_GT(single.decided, single.in_front / 2);
    EXPECT_GT(single.compared, kTries / 100);
  }
}

}  // namespace
}  // namespace alphascope
