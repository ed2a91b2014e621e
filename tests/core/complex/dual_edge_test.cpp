// Dual edges in single and double precision: whatever they decide must be what integers decide, on
// random and on nearly degenerate neighbourhoods; and so must the discs' cull.
#include "core/complex/dual_edge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/complex/exact_dual_edge.hpp"
#include "core/complex/facet_disc.hpp"

namespace alphascope {
namespace {

constexpr int kCount = 9;  // neighbours of ball i: j, k and seven that cut

struct Neighbourhood {
  std::array<LiftedInt, kCount> vectors;
  const LiftedInt& lifted(int slot) const { return vectors[static_cast<std::size_t>(slot)]; }
  int ball(int slot) const { return slot; }
};

// Neighbours of a ball at the origin, lattice units; a small `spread` gives many ties.
Neighbourhood random_neighbourhood(std::mt19937& random, int spread) {
  std::uniform_int_distribution<int> at(-spread, spread), radius(1, spread);
  Neighbourhood result;
  const std::int64_t own = radius(random);
  for (LiftedInt& v : result.vectors) {
    do {
      v = {at(random), at(random), at(random), 0};
    } while (v.x == 0 && v.y == 0 && v.z == 0);
    const std::int64_t other = radius(random);
    v.c = v.x * v.x + v.y * v.y + v.z * v.z + own * own - other * other;
  }
  return result;
}

template <class Real>
LiftedVector<Real> scaled(const LiftedInt& v, Real scale) {
  return {static_cast<Real>(v.x) * scale, static_cast<Real>(v.y) * scale,
          static_cast<Real>(v.z) * scale, static_cast<Real>(v.c) * scale * scale};
}

struct Count {
  std::size_t decided = 0, undecided = 0, found = 0, wrong = 0;
};

struct Ends {
  bool known;
  int high, low;  // -1: no tetrahedron of K_alpha
};

template <class Real>
Ends ends_of(const Neighbourhood& n, Real radius_square, Real scale) {
  if (DualEdge<Real>::certainly_outside(scaled(n.lifted(0), scale), scaled(n.lifted(1), scale),
                                        radius_square))
    return {true, -1, -1};
  DualEdge<Real> edge;
  if (!edge.start(scaled(n.lifted(0), scale), scaled(n.lifted(1), scale), radius_square))
    return {true, -1, -1};
  for (int m = 2; m < kCount; ++m) {
    const auto cut = edge.cut_by(scaled(n.lifted(m), scale));
    const auto takes = edge.takes(cut);
    if (takes == DualEdge<Real>::Takes::all) return {true, -1, -1};
    if (takes == DualEdge<Real>::Takes::some && edge.clip(cut, m)) return {true, -1, -1};
  }
  if (!edge.ends_certain() || !edge.certainly_there()) return {false, -1, -1};
  Ends ends{true, -1, -1};
  const auto judge = [&](const typename DualEdge<Real>::End& end, int& cutter) {
    if (end.cutter < 0) return;
    const Decision d = edge.within(end, radius_square);
    if (d == Decision::in) cutter = end.cutter;
    if (d == Decision::unknown) ends.known = false;
  };
  judge(edge.high(), ends.high);
  judge(edge.low(), ends.low);
  return ends;
}

class DualEdges : public ::testing::TestWithParam<int> {
 protected:
  // Exact answers by the definition: every candidate against every other ball.
  static int defined_end(const Neighbourhood& n, int side, std::int64_t weight, double alpha) {
    for (int l = 2; l < kCount; ++l) {
      if (sign_of(determinant(n.lifted(0), n.lifted(1), n.lifted(l))) != side) continue;
      bool empty = true;
      for (int m = 2; m < kCount; ++m) {
        if (m != l &&
            orthocentre_cut<WideInt<4>>(n.lifted(0), n.lifted(1), n.lifted(l), n.lifted(m)) > 0)
          empty = false;
      }
      const ExactRho rho = exact_tetrahedron_rho(n.lifted(0), n.lifted(1), n.lifted(l), weight);
      if (empty && compare_exact(rho, alpha) <= 0) return l;
    }
    return -1;
  }

  template <class Real>
  static Count compare(Real scale) {
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    const std::int64_t weight = std::int64_t{GetParam()} * GetParam() / 2;
    Count count;
    for (int round = 0; round < 40000; ++round) {
      const Neighbourhood n = random_neighbourhood(random, GetParam());
      double alpha = static_cast<double>(random() % static_cast<unsigned>(3 * weight + 1));
      if (round % 3 == 0) {  // next to the alpha value of a tetrahedron
        alpha = round_exact(exact_tetrahedron_rho(n.lifted(0), n.lifted(1), n.lifted(2), weight));
        if (!(alpha > -static_cast<double>(weight) && alpha < 1e9)) continue;
      }
      const auto square = static_cast<Real>(static_cast<double>(weight) + alpha) * scale * scale;
      const Ends ours = ends_of<Real>(n, square, scale);
      ++(ours.known ? count.decided : count.undecided);
      if (!ours.known) continue;
      const int high = defined_end(n, 1, weight, alpha), low = defined_end(n, -1, weight, alpha);
      count.found += (high >= 0) + (low >= 0);
      count.wrong += ours.high != high || ours.low != low;
    }
    return count;
  }
};
INSTANTIATE_TEST_SUITE_P(Spreads, DualEdges, ::testing::Values(2, 5, 60, 3000, 16000));

TEST_P(DualEdges, SinglePrecisionIsNeverWrong) {
  const Count count = compare<float>(1.0f / 32768);
  EXPECT_EQ(count.wrong, 0u);
  EXPECT_GT(count.found, 100u);
  EXPECT_GT(count.decided, GetParam() >= 3000 ? 15 * count.undecided : count.undecided / 4);
}

TEST_P(DualEdges, DoublePrecisionIsNeverWrong) {
  const Count count = compare<double>(1.0);
  EXPECT_EQ(count.wrong, 0u);
  EXPECT_GT(count.found, 100u);
}

TEST_P(DualEdges, ExactEndsAreThoseOfTheDefinition) {
  std::mt19937 random(7);
  const std::int64_t weight = std::int64_t{GetParam()} * GetParam() / 2;
  std::size_t found = 0;
  for (int round = 0; round < 8000; ++round) {
    const Neighbourhood n = random_neighbourhood(random, GetParam());
    const double alpha = static_cast<double>(random() % static_cast<unsigned>(3 * weight + 1));
    const FacetInput<Neighbourhood> in{n, 0, weight, alpha, 1, true};
    const auto next = [](int m) { return m < 2 ? 2 : m + 1 < kCount ? m + 1 : -1; };
    for (const int side : {1, -1}) {
      const int defined = defined_end(n, side, weight, alpha);
      EXPECT_EQ(exact_end<Int128>(in, 1, side, next), defined);
      EXPECT_EQ(exact_end<WideInt<4>>(in, 1, side, next), defined);
      found += defined >= 0;
    }
  }
  EXPECT_GT(found, 100u);
}

// A point of the disc that ball m keeps refutes "covered": the disc is sampled around its centre.
TEST_P(DualEdges, CoveredDiscsAreCovered) {
  std::mt19937 random(11);
  const float scale = 1.0f / 32768;
  std::size_t covered = 0;
  for (int round = 0; round < 40000; ++round) {
    const Neighbourhood n = random_neighbourhood(random, GetParam());
    const double square =
        static_cast<double>(random() % static_cast<unsigned>(3 * GetParam() * GetParam()));
    const FacetDisc<float> disc(scaled(n.lifted(0), scale),
                                static_cast<float>(square) * scale * scale);
    const auto j = lifted_as<double>(n.lifted(0)), m = lifted_as<double>(n.lifted(1));
    const double length = dot(j, j), depth = j.c * j.c / (4 * length);
    if (disc.certainly_empty()) {
      EXPECT_GT(depth, square);
      continue;
    }
    if (!disc.certainly_covered_by(scaled(n.lifted(1), scale)) || depth > square) continue;
    ++covered;
    // Farthest along -d_m in the plane: the point that m cuts off last.
    const double share = dot(m, j) / length;
    const Vector3<double> across{m.x - share * j.x, m.y - share * j.y, m.z - share * j.z};
    const double size = std::sqrt(dot(across, across));
    const double step = size > 0 ? std::sqrt(square - depth) / size : 0;
    const Vector3<double> last{j.x * j.c / (2 * length) - step * across.x,
                               j.y * j.c / (2 * length) - step * across.y,
                               j.z * j.c / (2 * length) - step * across.z};
    EXPECT_GT(2 * dot(m, last), m.c);
  }
  EXPECT_GT(covered, 400u);
}

}  // namespace
}  // namespace alphascope
