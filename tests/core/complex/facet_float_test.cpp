// The single-precision arithmetic of the GPU's hot path, on the host: whatever it decides must be what
// integers decide, on random and on nearly degenerate corners.
#include "core/complex/facet_float.hpp"

#include <gtest/gtest.h>

#include <random>

namespace alphascope {
namespace {

constexpr std::int64_t kGhost = std::int64_t{1} << 14;
constexpr float kScale = 1.0f / 32768;

LiftedVector<float> scaled(const LiftedInt& v) {
  return {static_cast<float>(v.x) * kScale, static_cast<float>(v.y) * kScale,
          static_cast<float>(v.z) * kScale, static_cast<float>(v.c) * kScale * kScale};
}

// Neighbours of a ball at the origin, lattice units; `spread` small gives many near-degenerate corners.
class Corners {
 public:
  Corners(unsigned seed, int spread) : random_(seed), at_(-spread, spread), radius_(1, spread) {}

  LiftedInt neighbour() {
    for (;;) {
      const std::int64_t x = at_(random_), y = at_(random_), z = at_(random_);
      if (x == 0 && y == 0 && z == 0) continue;
      const std::int64_t own = radius_(random_), other = radius_(random_);
      return {x, y, z, x * x + y * y + z * z + own * own - other * other};
    }
  }

 private:
  std::mt19937 random_;
  std::uniform_int_distribution<int> at_, radius_;
};

struct Count {
  std::size_t decided = 0, undecided = 0, wrong = 0;
  void add(int sign, int exact) {
    ++(sign == 0 ? undecided : decided);
    wrong += sign != 0 && sign != exact;
  }
};

// One facet's plane and a corner of it where two lines meet counter-clockwise.
struct Case {
  LiftedInt j, k, l;
  FacetAxis axis;
  FloatFrame frame;
  FloatCorner corner;
};

bool make_case(Corners& corners, Case& c) {
  c.j = corners.neighbour();
  c.k = corners.neighbour();
  c.l = corners.neighbour();
  c.axis = facet_axis(c.j.x, c.j.y, c.j.z);
  const auto exact = make_facet_frame(lifted_as<WideInt<4>>(c.j), c.axis.axis, c.axis.negative);
  FacetCorner<WideInt<4>> corner;
  corner.meet(exact.line(lifted_as<WideInt<4>>(c.k)), exact.line(lifted_as<WideInt<4>>(c.l)));
  if (sign_of(corner.w) == 0) return false;
  if (sign_of(corner.w) < 0) std::swap(c.k, c.l);
  c.frame = make_float_frame(scaled(c.j), c.axis);
  c.corner.meet(c.frame.line(scaled(c.k)), c.frame.line(scaled(c.l)));
  return true;
}

class FacetFloat : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Spreads, FacetFloat, ::testing::Values(2, 5, 60, 3000, 16000));

TEST_P(FacetFloat, NeverDecidesASideWrongly) {
  Corners corners(1, GetParam());
  Count sides, boxes;
  for (int n = 0; n < 100000; ++n) {
    Case c;
    if (!make_case(corners, c)) continue;
    const LiftedInt m = corners.neighbour();
    const FloatSideTest test(c.frame.line(scaled(m)));
    const int exact = corner_cut_exact<WideInt<4>>(c.j, c.axis, c.k, c.l, m);
    sides.add(test.side(c.corner), exact);
    FloatBox box;
    box.clear();
    box.add(c.corner);
    box.finish();
    if (test.spares(box)) boxes.add(-1, exact);
    const int in_double = corner_cut_filtered(c.j, c.axis, c.k, c.l, m);
    EXPECT_TRUE(in_double == 0 || in_double == exact);
  }
  EXPECT_EQ(sides.wrong, 0u);
  EXPECT_EQ(boxes.wrong, 0u);
  EXPECT_GT(boxes.decided, 10000u);
  // At the sizes of molecules nearly every corner is decided; tiny lattices are full of ties.
  EXPECT_GT(sides.decided, GetParam() >= 3000 ? 300 * sides.undecided : sides.undecided);
}

TEST(FacetFloat, GhostsAreTheSameInEveryPrecision) {
  for (int axis = 0; axis < 3; ++axis) {
    const LiftedInt j = axis == 0 ? LiftedInt{5, 1, -2, 30} : axis == 1 ? LiftedInt{1, -5, 2, 30} : LiftedInt{-1, 2, 5, 30};
    const FacetAxis a = facet_axis(j.x, j.y, j.z);
    ASSERT_EQ(a.axis, axis);
    const auto frame = make_facet_frame(lifted_as<double>(j), a.axis, a.negative);
    for (const int id : {kGhostY, kGhostZ, kGhostYZ}) {
      const auto line = frame.line(lifted_as<double>(ghost_vector(id, axis, kGhost)));
      const FloatLine scaled_line = ghost_line(id, static_cast<float>(kGhost));
      EXPECT_EQ(line.a, frame.q.x * static_cast<double>(scaled_line.a));
      EXPECT_EQ(line.b, frame.q.x * static_cast<double>(scaled_line.b));
      EXPECT_EQ(line.c, 2 * frame.q.x * static_cast<double>(scaled_line.t));
    }
  }
}

}  // namespace
}  // namespace alphascope
