// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target: bytes become a few balls on a small lattice and some alphas. Dual edges, the
// CPU engine and CGAL must give the same complex, which must meet the definition.
//
// First byte: bits 0-1 are the scale of coordinates, bits 2-4 the number of alphas. One byte per
// alpha follows, then four bytes per ball (x, y, z, radius), at most kMostBalls.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/complex/compare.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/verify/verify.hpp"
#include "tests/support/dual_edge_only_engine.hpp"
#include "tests/support/keeping_engine.hpp"

namespace {

using namespace alphascope;

constexpr std::size_t kMostBalls = 24;

struct Input {
  BallSet balls;
  std::vector<double> alphas;
};

Input decode(const std::uint8_t* data, std::size_t size) {
  Input input;
  input.balls.lattice.digits = 0;
  if (size == 0) return input;
  const int scales[4] = {1, 3, 1000, 2000003};
  const int scale = scales[data[0] & 3];
  const std::size_t alpha_count = std::min<std::size_t>(data[0] >> 2 & 7, size - 1);
  for (std::size_t n = 0; n < alpha_count; ++n) {
    const int value = static_cast<std::int8_t>(data[1 + n]);
    input.alphas.push_back(0.25 * value * scale * scale);
  }
  for (std::size_t at = 1 + alpha_count; at + 4 <= size; at += 4) {
    if (input.balls.size() == kMostBalls) break;
    const auto coordinate = [&](std::size_t n) {
      return static_cast<std::int8_t>(data[at + n]) / 8 * scale;
    };
    input.balls.centres.push_back({coordinate(0), coordinate(1), coordinate(2)});
    input.balls.radii.push_back((1 + data[at + 3] % 24) * std::min(scale, 1000000));
  }
  return input;
}

void require(bool good, const char* what, const Input& input, double alpha) {
  if (good) return;
  std::fprintf(stderr, "%s at alpha %.17g of\n", what, alpha);
  for (std::size_t i = 0; i < input.balls.size(); ++i) {
    const LatticePoint& p = input.balls.centres[i];
    std::fprintf(stderr, "%d %d %d %d\n", p.x, p.y, p.z, input.balls.radii[i]);
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Input input = decode(data, size);
  const auto balls = std::make_shared<const BallSet>(input.balls);
  const auto reference = testing::keeping(make_cgal_engine(balls, {1}));
  const auto cpu = testing::keeping(make_cpu_engine(balls, {1}));
  testing::DualEdgeOnlyEngine dual_edges(balls, 1);
  for (const double alpha : input.alphas) {
    const AlphaComplex expected = reference->compute({alpha}, {});
    require(compare(dual_edges.compute({alpha}, {}), expected).identical(), "dual edges differ",
            input, alpha);
    require(compare(cpu->compute({alpha}, {}), expected).identical(), "CPU engine differs", input,
            alpha);
    require(compare(dual_edges.compute({alpha, true}, {}), expected).identical(),
            "tetrahedra of dual edges differ", input, alpha);
    require(verify(input.balls, expected).ok(), "definition not met", input, alpha);
  }
  return 0;
}
