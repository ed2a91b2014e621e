// SPDX-License-Identifier: GPL-3.0-or-later
// Tests dual edges and the cull of discs in single and double precision. All decisions must be
// those of integers, on random and nearly degenerate neighbourhoods.
#include "core/dual_edge/dual_edge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "core/dual_edge/dual_edge_probe.hpp"
#include "core/dual_edge/facet_disc.hpp"
#include "core/dual_edge/triangle_faces.hpp"

namespace alphascope {
namespace {

constexpr int kCount = 9;  // neighbours of ball i: j, k and seven that cut

struct Neighbours {
  std::array<LiftedInt, kCount> vectors;
  const LiftedInt& lifted(int slot) const { return vectors[static_cast<std::size_t>(slot)]; }
  int ball(int slot) const { return slot; }
};

// Neighbours of a ball at the origin, at distinct places. A small `spread` gives many ties.
Neighbours random_neighbours(std::mt19937& random, int spread) {
  std::uniform_int_distribution<int> at(-spread, spread), radius(1, spread);
  const std::int64_t own = radius(random);
  std::set<std::array<std::int64_t, 3>> taken{{0, 0, 0}};
  Neighbours result;
  for (LiftedInt& v : result.vectors) {
    do {
      v = {at(random), at(random), at(random), 0};
    } while (!taken.insert({v.x, v.y, v.z}).second);
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
  std::size_t decided = 0, undecided = 0, found = 0, ends = 0, attached = 0, wrong = 0;
};

// Every neighbour but j (0) and k (1) cuts, as a row of bits.
constexpr std::uint32_t kOthers = ((1u << kCount) - 1) & ~3u;
constexpr TriangleRows kTriangle{0, 1, &kOthers, &kOthers};

template <class Real>
TriangleFace filtered(const Neighbours& n, Real radius_square, Real scale) {
  const auto lifted = [&](int m) { return scaled(n.lifted(m), scale); };
  if (DualEdge<Real>::certainly_outside(lifted(0), lifted(1), radius_square))
    return TriangleFace::absent();
  return filtered_face<Real>(kTriangle, 1, radius_square, lifted);
}

// Finds a face by its definition. It tests every ball that may end the dual edge against every
// other ball.
class Definition {
 public:
  Definition(const Neighbourhood<Neighbours>& in, const Neighbours& n) : in_(in), n_(n) {
    face_ = TriangleFace::absent();
    const auto normal = cross(n.lifted(0), n.lifted(1));
    if (normal.x == 0 && normal.y == 0 && normal.z == 0) return;
    const EndBall high = end(1), low = end(-1);
    if (high.slot == kNothing || low.slot == kNothing) return;
    face_.in = compare_exact(exact_triangle_rho(n.lifted(0), n.lifted(1), in.weight), *in.alpha) > 0
                   ? Decision::out
                   : Decision::in;
    judge(high, face_.high, TriangleFace::Attached::high);
    judge(low, face_.low, TriangleFace::Attached::low);
  }
  const TriangleFace& face() const { return face_; }

 private:
  static constexpr int kNothing = -2;

  // The ball at the end on this side; the ghost if no ball ends it there.
  EndBall end(int side) const {
    const EndBall ghost = ghost_end(n_.lifted(0), n_.lifted(1), side, in_.ghost_reach);
    if (survives(ghost)) return ghost;
    for (int l = 2; l < kCount; ++l) {
      if (sign_of(determinant(n_.lifted(0), n_.lifted(1), n_.lifted(l))) != side) continue;
      if (survives({l, n_.lifted(l)})) return {l, n_.lifted(l)};
    }
    return {kNothing, {}};
  }
  bool survives(const EndBall& end) const {
    for (int m = 2; m < kCount; ++m) {
      if (m != end.slot &&
          orthocentre_cut<WideInt<4>>(n_.lifted(0), n_.lifted(1), end, n_.lifted(m)) > 0)
        return false;
    }
    return true;
  }
  void judge(const EndBall& end, int& slot, TriangleFace::Attached side) {
    if (end.slot < 0) return;
    const ExactRho rho = exact_tetrahedron_rho(n_.lifted(0), n_.lifted(1), end.lifted, in_.weight);
    const bool in = compare_exact(rho, *in_.alpha) <= 0;
    if (in) slot = end.slot;
    if (triangle_foot_cut_exact(n_.lifted(0), n_.lifted(1), end.lifted) <= 0) return;
    face_.attached = side;
    face_.in = in ? Decision::in : Decision::out;
  }

  const Neighbourhood<Neighbours>& in_;
  const Neighbours& n_;
  TriangleFace face_;
};

bool same(const TriangleFace& a, const TriangleFace& b) {
  if (a.in != b.in) return false;
  return a.in != Decision::in || (a.high == b.high && a.low == b.low && a.attached == b.attached);
}

class DualEdges : public ::testing::TestWithParam<int> {
 protected:
  std::int64_t weight() const { return std::int64_t{GetParam()} * GetParam() / 2; }
  // In every third round `alpha` is next to the alpha value of a simplex.
  double alpha_of(const Neighbours& n, int round, std::mt19937& random) const {
    const double any = whole_below(3.0 * static_cast<double>(weight()) + 1, random);
    if (round % 3 != 0) return any;
    return round % 2 == 0
               ? round_exact(exact_tetrahedron_rho(n.lifted(0), n.lifted(1), n.lifted(2), weight()))
               : round_exact(exact_triangle_rho(n.lifted(0), n.lifted(1), weight()));
  }
  static double whole_below(double most, std::mt19937& random) {
    return std::floor(most * random() / 4294967296.0);
  }
  // Returns the power of two that scales vectors between balls that meet to lengths below 1.
  float scale() const {
    return std::ldexp(1.0f, -std::ilogb(2.0f * static_cast<float>(GetParam())) - 1);
  }
  bool sensible(double alpha) const {
    return alpha > -static_cast<double>(weight()) &&
           alpha < std::max(1e9, 40.0 * static_cast<double>(weight()));
  }
  Neighbourhood<Neighbours> around(const Neighbours& n, double alpha) const {
    const auto reach =
        static_cast<std::int64_t>(std::sqrt(static_cast<double>(weight()) + alpha)) + 2;
    alpha_ = alpha;
    return {n, weight(), &alpha_, reach, true};
  }
  mutable LatticeAlpha alpha_;  // of the last around()

  template <class Real>
  Count compare(Real scale) const {
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    Count count;
    for (int round = 0; round < 40000; ++round) {
      const Neighbours n = random_neighbours(random, GetParam());
      const double alpha = alpha_of(n, round, random);
      if (!sensible(alpha)) continue;
      const auto square = static_cast<Real>(static_cast<double>(weight()) + alpha) * scale * scale;
      const TriangleFace ours = filtered<Real>(n, square, scale);
      ++(ours.in != Decision::unknown ? count.decided : count.undecided);
      if (ours.in == Decision::unknown) continue;
      const TriangleFace defined = Definition(around(n, alpha), n).face();
      count.found += ours.in == Decision::in;
      count.ends += (ours.high >= 0) + (ours.low >= 0);
      count.attached += ours.in == Decision::in && ours.attached != TriangleFace::Attached::no;
      count.wrong += !same(ours, defined);
    }
    return count;
  }
};
INSTANTIATE_TEST_SUITE_P(Spreads, DualEdges,
                         ::testing::Values(2, 5, 60, 3000, 16000, (1 << 23) - 1));

TEST_P(DualEdges, SinglePrecisionIsNeverWrong) {
  const Count count = compare<float>(scale());
  EXPECT_EQ(count.wrong, 0u);
  EXPECT_GT(count.found, 100u);
  EXPECT_GT(count.ends, 100u);
  EXPECT_GT(count.attached, 20u);
  EXPECT_GT(count.decided, GetParam() >= 3000 ? 15 * count.undecided : count.undecided / 4);
}

TEST_P(DualEdges, DoublePrecisionIsNeverWrong) {
  const Count count = compare<double>(1.0);
  EXPECT_EQ(count.wrong, 0u);
  EXPECT_GT(count.found, 100u);
  EXPECT_GT(count.attached, 20u);
}

// A triangle that the probe drops must not be a simplex. The probe drops nearly as many triangles
// as clip() does.
TEST_P(DualEdges, ProbedAwayTrianglesAreNone) {
  std::mt19937 random(3);
  const float scale = 2 * this->scale();
  std::size_t dropped = 0, clipped = 0, wrong = 0;
  for (int round = 0; round < 40000; ++round) {
    const Neighbours n = random_neighbours(random, GetParam());
    const double alpha = alpha_of(n, round, random);
    if (!sensible(alpha)) continue;
    const auto lifted = [&](int m) { return scaled(n.lifted(m), scale); };
    const float square = static_cast<float>(static_cast<double>(weight()) + alpha) * scale * scale;
    DualEdge<float> edge;
    if (!edge.start(lifted(0), lifted(1), square)) continue;
    DualEdgeProbe<float> probe(edge, 1.75f, 2);
    bool gone = false;
    for (int m = 2; m < kCount; ++m) gone = probe.clip(lifted(m)) || gone;
    clipped += clips_away(edge, kTriangle, 1, lifted);
    if (!gone) continue;
    ++dropped;
    wrong += Definition(around(n, alpha), n).face().in == Decision::in;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(clipped, 1000u);
  EXPECT_GT(10 * dropped, GetParam() >= 3000 ? 9 * clipped : 2 * clipped);
}

TEST_P(DualEdges, ExactFacesAreThoseOfTheDefinition) {
  std::mt19937 random(7);
  std::size_t found = 0;
  for (int round = 0; round < 8000; ++round) {
    const Neighbours n = random_neighbours(random, GetParam());
    const double alpha = alpha_of(n, round, random);
    if (!sensible(alpha)) continue;
    const auto in = around(n, alpha);
    const TriangleFace defined = Definition(in, n).face();
    if (GetParam() < kSmallOffset) {
      EXPECT_TRUE(same(exact_face<Int128>(in, kTriangle, 1), defined));
    }
    EXPECT_TRUE(same(exact_face<WideInt<4>>(in, kTriangle, 1), defined));
    found += defined.in == Decision::in;
  }
  EXPECT_GT(found, 100u);
}

TEST_P(DualEdges, CutCentresOfDiscsAreCut) {
  std::mt19937 random(5);
  const float scale = this->scale();
  std::size_t in = 0, out = 0;
  for (int round = 0; round < 40000; ++round) {
    const Neighbours n = random_neighbours(random, GetParam());
    const FacetDisc<float> disc(scaled(n.lifted(0), scale), 1.0f);
    const Decision ours = disc.centre_cut_by(scaled(n.lifted(1), scale));
    const int exact = edge_foot_cut_exact(n.lifted(0), n.lifted(1));
    if (ours == Decision::in) {
      EXPECT_EQ(exact, 1);
    } else if (ours == Decision::out) {
      EXPECT_EQ(exact, -1);
    }
    in += ours == Decision::in;
    out += ours == Decision::out;
  }
  EXPECT_GT(in, 1000u);
  EXPECT_GT(out, 1000u);
}

// If any point of the disc is not cut off, the disc is not covered. The test tries points of the
// disc around its centre.
TEST_P(DualEdges, CoveredDiscsAreCovered) {
  std::mt19937 random(11);
  const float scale = this->scale();
  std::size_t covered = 0;
  for (int round = 0; round < 40000; ++round) {
    const Neighbours n = random_neighbours(random, GetParam());
    const double square = whole_below(3.0 * GetParam() * GetParam(), random);
    const FacetDisc<float> disc(scaled(n.lifted(0), scale),
                                static_cast<float>(square) * scale * scale);
    const auto j = lifted_as<double>(n.lifted(0)), m = lifted_as<double>(n.lifted(1));
    const double length = dot(j, j), depth = j.c * j.c / (4 * length);
    if (disc.certainly_empty()) {
      EXPECT_GT(depth, square);
      continue;
    }
    if (!disc.covered_by(FacetDisc<float>::coverer(scaled(n.lifted(1), scale))) || depth > square)
      continue;
    ++covered;
    // The point of the disc farthest along -d_m, which m cuts off last.
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
