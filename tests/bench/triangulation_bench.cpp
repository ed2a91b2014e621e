// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and times whole triangulations on a machine with a GPU. Each is compared with CGAL's, byte
// by byte, unless there are more than four million balls: then its certificate has to do. Usage:
//   alphascope_triangulation_bench RUNS FILE.balls[:SOLVENT]...
// Times are medians in ms, from balls in host memory to a triangulation in host memory, after two
// runs to warm up. CGAL runs once for each number of threads. Device memory is that of the first
// to last run of a set, without what was kept from the set before.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/run/work_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/wrapping/seed.hpp"
#include "gpu/memory/device_memory.hpp"
#include "gpu/wrapping/triangulator.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/bench/times.hpp"

using namespace alphascope;

namespace {

using bench::Clock;
using bench::median;
using bench::milliseconds;

constexpr std::size_t kMostCompared = 4'000'000;

// Returns whether the result is CGAL's.
bool time_set(DeviceTriangulator& triangulator, const std::string& name, const BallSet& balls,
              int runs) {
  const bool compared = balls.size() <= kMostCompared;
  double one = 0, sixteen = 0;
  Triangulation whole;
  if (compared) {
    const auto begun = Clock::now();
    whole = make_cgal_triangulation(balls, 1);
    one = milliseconds(begun);
    const auto again = Clock::now();
    whole = make_cgal_triangulation(balls, 16);
    sixteen = milliseconds(again);
  }
  triangulator.release_memory();
  gpu::DeviceMemory::forget_most();
  auto start = Clock::now();
  DeviceTriangulation made = triangulator.make(balls, {});
  const double first = milliseconds(start);
  const bool equal = made.triangulation && (!compared || *made.triangulation == whole);
  std::printf("%s %s: balls %zu",
              !equal     ? "DIFF"
              : compared ? "ok  "
                         : "certified",
              name.c_str(), balls.size());
  if (made.triangulation)
    std::printf(", hidden %zu, tetrahedra %zu", made.triangulation->hidden.size(),
                made.triangulation->tetrahedra.size());
  if (compared) std::printf(" (CGAL %.1f ms, with 16 threads %.1f)", one, sixteen);
  std::printf("\n");
  if (!made.triangulation) {
    std::printf("  none: %s\n", made.report.why_not.c_str());
    return false;
  }
  std::vector<double> wall, anew;
  std::vector<std::vector<double>> stages;
  for (int run = 0; run < 3; ++run) {
    made = {};
    triangulator.release_memory();
    start = Clock::now();
    made = triangulator.make(balls, {});
    anew.push_back(milliseconds(start));
  }
  for (int run = 0; run < runs + 2; ++run) {
    made = {};  // as a program that shows one triangulation at a time
    start = Clock::now();
    made = triangulator.make(balls, {});
    if (run < 2) continue;
    wall.push_back(milliseconds(start));
    stages.resize(made.report.timings.stages.size());
    for (std::size_t s = 0; s < stages.size(); ++s)
      stages[s].push_back(made.report.timings.stages[s].milliseconds);
  }
  std::printf(
      "  wall %.2f (least %.2f; first %.2f; with new memory %.2f); known %llu, open faces %llu, "
      "balls needed %llu, waves %llu; device memory at most %.0f MB\n ",
      median(wall), *std::min_element(wall.begin(), wall.end()), first, median(anew),
      static_cast<unsigned long long>(made.report.known),
      static_cast<unsigned long long>(made.report.open_faces),
      static_cast<unsigned long long>(made.report.needed),
      static_cast<unsigned long long>(made.report.waves),
      static_cast<double>(gpu::DeviceMemory::most_held()) / 1e6);
  for (std::size_t s = 0; s < stages.size(); ++s)
    std::printf(" %s %.2f,", made.report.timings.stages[s].label.c_str(), median(stages[s]));
  std::printf("\n");
  std::fflush(stdout);
  return equal;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: alphascope_triangulation_bench RUNS FILE.balls[:SOLVENT]...\n");
    return 2;
  }
  const auto triangulator = make_gpu_triangulator(seed_tetrahedron);
  bool equal = true;
  for (int n = 2; n < argc; ++n) {
    const std::string word = argv[n];
    const BallSet balls = bench::read_grown_balls(word);
    equal = time_set(*triangulator, word, balls, std::atoi(argv[1])) && equal;
  }
  return equal ? 0 : 1;
}
