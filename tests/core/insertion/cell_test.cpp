// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the numbers of cells never contradict integers, up to the limits of the lattice.
#include "core/insertion/cell.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>

#include "core/geometry/lattice_point.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;
using testing::random_int;

struct Ball {
  LatticePoint p;
  std::int32_t radius;

  InsertedBall inserted() const {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z),
            static_cast<double>(std::int64_t{radius} * radius)};
  }
  LiftedInt from(const Ball& i) const { return lifted_vector(i.p, i.radius, p, radius); }
};

CornerBall corner(const Ball& i, const Ball& m) {
  return CornerBall(seen_from(i.inserted(), m.inserted()));
}

struct Counts {
  int cells = 0, decided = 0, undecided = 0;
};

// Checks the side of the last ball of five, of which the first four make a cell.
void check_tetrahedron(std::array<Ball, 5> balls, Counts& counts) {
  LiftedInt j = balls[1].from(balls[0]), k = balls[2].from(balls[0]), l = balls[3].from(balls[0]);
  const int side = orientation(j, k, l);
  if (side == 0) return;
  if (side < 0) {
    std::swap(balls[2], balls[3]);
    std::swap(k, l);
  }
  ++counts.cells;
  Cell cell;
  certify_cell(corner(balls[0], balls[1]), corner(balls[0], balls[2]), corner(balls[0], balls[3]),
               cell);
  const SeenBall m = seen_from(balls[0].inserted(), balls[4].inserted());
  const double value = m.x * cell.x + m.y * cell.y + m.z * cell.z - m.c;
  const double error =
      cell.error * (std::fabs(m.x) + std::fabs(m.y) + std::fabs(m.z)) + 6 * kUnitRoundoff * m.size;
  if (!(std::fabs(value) > error)) {
    ++counts.undecided;
    return;
  }
  ++counts.decided;
  const LiftedInt exact = balls[4].from(balls[0]);
  EXPECT_EQ(value > 0 ? 1 : -1, orthocentre_cut<WideInt<4>>(j, k, {0, l}, exact));
}

void check_facet(const std::array<Ball, 4>& balls, Counts& counts) {
  const LiftedInt j = balls[1].from(balls[0]), k = balls[2].from(balls[0]),
                  exact = balls[3].from(balls[0]);
  ++counts.cells;
  Cell cell;
  certify_cell_at_infinity(corner(balls[0], balls[1]), corner(balls[0], balls[2]), cell);
  const SeenBall m = seen_from(balls[0].inserted(), balls[3].inserted());
  const double value = m.x * cell.x + m.y * cell.y + m.z * cell.z;
  if (!(std::fabs(value) > cell.error * (std::fabs(m.x) + std::fabs(m.y) + std::fabs(m.z)))) {
    ++counts.undecided;
    return;
  }
  ++counts.decided;
  EXPECT_EQ(value > 0 ? 1 : -1, orientation(j, k, exact));
}

// Balls on one sphere, some moved by a unit, so that doubles are near their limits.
class NearlyOnASphere {
 public:
  NearlyOnASphere(Random& random, int bits) : random_(random) {
    const int most = (1 << bits) - 1;
    for (int& c : corner_) c = random_int(random, most / 4, most);
    radius_ = random_int(random, 1, std::min(most, kMaxLatticeRadius - 1));
  }
  Ball ball() {
    std::array<int, 3> p = corner_;
    std::shuffle(p.begin(), p.end(), random_);
    for (int& c : p) c *= random_int(random_, 0, 1) != 0 ? 1 : -1;
    const auto moved = [&] {
      return random_int(random_, 0, 3) == 0 ? random_int(random_, -1, 1) : 0;
    };
    return {{p[0] + moved(), p[1] + moved(), p[2] + moved()}, radius_ + moved()};
  }

 private:
  Random& random_;
  std::array<int, 3> corner_;
  int radius_;
};

TEST(Cell, NeverContradictsIntegers) {
  Random random(61);
  for (int bits = 3; bits <= 28; ++bits) {
    Counts tetrahedra, facets;
    for (int n = 0; n < 4000; ++n) {
      NearlyOnASphere set(random, bits);
      const std::array<Ball, 5> balls{set.ball(), set.ball(), set.ball(), set.ball(), set.ball()};
      check_tetrahedron(balls, tetrahedra);
      check_facet({balls[0], balls[1], balls[2], balls[3]}, facets);
    }
    EXPECT_GT(tetrahedra.cells, 1000) << bits;
    EXPECT_GT(tetrahedra.decided, 100) << bits;
    EXPECT_GT(tetrahedra.undecided, 100) << bits;
    EXPECT_GT(facets.decided, 1000) << bits;
    EXPECT_GT(facets.undecided, 100) << bits;
  }
}

// Flat tetrahedra have far orthocentres.
TEST(Cell, OfNearlyFlatBallsNeverContradictsIntegers) {
  Random random(62);
  Counts counts;
  for (int n = 0; n < 200000; ++n) {
    const int size = 1 << random_int(random, 2, 28);
    std::array<Ball, 5> balls;
    for (Ball& b : balls)
      b = {{random_int(random, -size, size), random_int(random, -size, size),
            random_int(random, -2, 2)},
           random_int(random, 1, std::min(size, kMaxLatticeRadius))};
    check_tetrahedron(balls, counts);
  }
  EXPECT_GT(counts.decided, 50000);
}

// The determinant of narrow tetrahedra is smaller than the roundings of its terms.
TEST(Cell, OfNarrowTetrahedraNeverContradictsIntegers) {
  Random random(63);
  Counts counts;
  for (int n = 0; n < 100000; ++n) {
    const int size = 1 << random_int(random, 10, 28);
    const auto far = [&] { return random_int(random, -size, size); };
    const LatticePoint a{far(), far(), far()}, b{-a.x, -a.y, -a.z};
    const auto near = [&](const LatticePoint& p) {
      const auto beside = [&] { return random_int(random, -2, 2); };
      return Ball{{p.x + beside(), p.y + beside(), p.z + beside()},
                  random_int(random, 1, std::min(size, kMaxLatticeRadius))};
    };
    check_tetrahedron({near(a), near(b), near(b), near(a), {{far(), far(), far()}, 1}}, counts);
  }
  EXPECT_GT(counts.decided, 1000);
  EXPECT_GT(counts.undecided, 10000);
}

// Without a sign of the determinant the cell decides nothing.
TEST(Cell, WithoutAVolumeDecidesNothing) {
  const int far = kMaxLatticeCoordinate;
  const Ball i{{-far, -far, -far}, 1}, j{{far, far, far}, 1}, k{{far - 1, far, far}, 1},
      l{{far, far - 1, far}, 1};
  Cell cell;
  certify_cell(corner(i, j), corner(i, k), corner(i, l), cell);
  EXPECT_TRUE(std::isinf(cell.error));
}

}  // namespace
}  // namespace alphascope
