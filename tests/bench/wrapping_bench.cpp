// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and times the completion of a triangulation on a machine with a GPU. It starts with the
// tetrahedra within alpha and compares the whole with CGAL's triangulation. Usage:
//   alphascope_wrapping_bench ALPHA RUNS FILE.balls[:SOLVENT]...
// Alpha in Å². Times are medians in ms.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/wrapping/wrapping.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/bench/times.hpp"

using namespace alphascope;

namespace {

using Tetrahedra = std::vector<std::array<BallIndex, 4>>;

using bench::median;

// Returns whether the result is CGAL's.
bool time_set(const std::string& name, const BallSet& balls, double alpha, int runs) {
  using Clock = std::chrono::steady_clock;
  const auto milliseconds = [](Clock::time_point from) {
    return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
  };
  const auto start = Clock::now();
  const Triangulation whole = make_cgal_triangulation(balls, 16);
  const double cgal = milliseconds(start);
  gpu::DualEdgePipeline pipeline(balls);
  const LatticeAlpha on_lattice = balls.lattice.alpha_on_lattice(Alpha{alpha});
  const gpu::PipelineResult within = pipeline.run(on_lattice, true, {}, nullptr);
  const auto& known = within.tetrahedra.simplices;
  gpu::Wrapping wrapping(balls);
  const double radius = std::sqrt(alpha) * balls.lattice.units_per_angstrom();
  const std::size_t room = whole.tetrahedra.size() - known.size() + 1024;
  gpu::WrappingResult result = wrapping.run(known, radius, room, true, {});
  Tetrahedra all(known.begin(), known.end());
  all.insert(all.end(), result.found.begin(), result.found.end());
  std::sort(all.begin(), all.end());
  const bool equal = result.fits && std::equal(all.begin(), all.end(), whole.tetrahedra.begin(),
                                               whole.tetrahedra.end());
  std::vector<double> open, tree, front;
  for (int run = 0; run < runs + 2; ++run) {
    const gpu::WrappingResult next = wrapping.run(known, radius, room, false, {});
    if (run < 2) continue;
    open.push_back(next.open_ms);
    tree.push_back(next.tree_ms);
    front.push_back(next.front_ms);
  }
  const auto rounds = wrapping.run(known, radius, room, false, {}, true).timed;
  std::printf(
      "%s %s: balls %zu, tetrahedra %zu, known %zu, found %zu (CGAL %.1f ms, 16 threads)\n"
      "  open faces %zu, balls needed %zu, rounds %zu, hull %zu (%zu)\n"
      "  order %.3f, open faces %.3f, tree and grids %.3f, front %.3f\n",
      equal ? "ok  " : "DIFF", name.c_str(), balls.size(), whole.tetrahedra.size(), known.size(),
      result.found.size(), cgal, result.open, result.needed, result.rounds, result.hull,
      whole.hull.size(), result.order_ms, median(open), median(tree), median(front));
  constexpr const char* kNames[] = {"near", "far", "wide", "doubtful", "exact"};
  for (const auto& round : rounds) {
    std::printf("  round:");
    for (std::size_t search = 0; search < round.faces.size(); ++search)
      std::printf(" %s %zu in %.3f,", kNames[search], round.faces[search],
                  round.milliseconds[search]);
    std::printf(" extending %.3f\n", round.milliseconds.back());
  }
  std::fflush(stdout);
  return equal;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: alphascope_wrapping_bench ALPHA RUNS FILE.balls[:SOLVENT]...\n");
    return 2;
  }
  bool equal = true;
  for (int n = 3; n < argc; ++n) {
    const std::string word = argv[n];
    const BallSet balls = bench::read_grown_balls(word);
    equal = time_set(word, balls, std::atof(argv[1]), std::atoi(argv[2])) && equal;
  }
  return equal ? 0 : 1;
}
