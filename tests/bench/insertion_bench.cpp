// SPDX-License-Identifier: GPL-3.0-or-later
// Compares and times triangulations on the CPU: by insertion and by CGAL, in turns. Usage:
//   alphascope_insertion_bench RUNS THREADS[,THREADS...] FILE.balls[:SOLVENT]...
// Times are medians in ms, from balls to a triangulation in order, after one run to warm up.
// Results are compared byte by byte.
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "core/insertion/insertion.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/bench/times.hpp"

using namespace alphascope;

namespace {

using bench::Clock;
using bench::median;
using bench::milliseconds;

// Returns whether both results are the same.
bool time_set(const std::string& name, const BallSet& balls, int threads, int runs) {
  WorkThreads work(threads);
  std::vector<double> ours, theirs;
  Triangulation by_insertion, by_cgal;
  InsertionCounts counts;
  work.run([&] {
    for (int run = 0; run <= runs; ++run) {
      by_insertion = {};
      counts = {};
      auto start = Clock::now();
      auto made = triangulate_by_insertion(balls, threads, {}, &counts);
      if (run > 0) ours.push_back(milliseconds(start));
      if (made) by_insertion = *std::move(made);
      by_cgal = {};
      start = Clock::now();
      by_cgal = make_cgal_triangulation(balls, threads);
      if (run > 0) theirs.push_back(milliseconds(start));
    }
  });
  const bool equal = by_cgal.dimension < 3 || by_insertion == by_cgal;
  std::printf(
      "%s %s, threads %d: balls %zu, tetrahedra %zu, hidden %zu: insertion %.2f ms, CGAL "
      "%.2f ms (%.2f); inserters %zu, put off %llu, one by one %llu\n",
      equal ? "ok  " : "DIFF", name.c_str(), threads, balls.size(), by_cgal.tetrahedra.size(),
      by_cgal.hidden.size(), median(ours), median(theirs), median(theirs) / median(ours),
      counts.inserters, static_cast<unsigned long long>(counts.put_off),
      static_cast<unsigned long long>(counts.one_by_one));
  std::fflush(stdout);
  return equal;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(
        stderr,
        "usage: alphascope_insertion_bench RUNS THREADS[,THREADS...] FILE.balls[:SOLVENT]...\n");
    return 2;
  }
  bool equal = true;
  for (int n = 3; n < argc; ++n) {
    const std::string word = argv[n];
    const BallSet balls = bench::read_grown_balls(word);
    std::istringstream list(argv[2]);
    for (std::string threads; std::getline(list, threads, ',');)
      equal = time_set(word, balls, std::atoi(threads.c_str()), std::atoi(argv[1])) && equal;
  }
  return equal ? 0 : 1;
}
