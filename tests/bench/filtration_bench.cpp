// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a whole triangulation, its filtration, and moves of alpha on it: times and reserved
// memory. Prints least, quartiles and most of all moves, for use on a shared machine.
//
//   alphascope_filtration_bench FILE.balls|FILE.xyzr [THREADS [MOVES [verify]]]
#include <malloc.h>
#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <memory>
#include <new>
#include <random>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/verify/verify_triangulation.hpp"
#include "tests/bench/read_balls.hpp"

namespace {

std::atomic<std::int64_t> live_bytes = 0, most_bytes = 0;

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const auto size = static_cast<std::int64_t>(malloc_usable_size(memory));
  const std::int64_t live = live_bytes.fetch_add(size, std::memory_order_relaxed) + size;
  std::int64_t most = most_bytes.load(std::memory_order_relaxed);
  while (most < live && !most_bytes.compare_exchange_weak(most, live)) {
  }
  return memory;
}
void release(void* memory) {
  if (memory == nullptr) return;
  live_bytes.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(memory)),
                       std::memory_order_relaxed);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t align) {
  return counted(std::aligned_alloc(static_cast<std::size_t>(align),
                                    (size + static_cast<std::size_t>(align) - 1) /
                                        static_cast<std::size_t>(align) *
                                        static_cast<std::size_t>(align)));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

namespace {

using namespace alphascope;
using Clock = std::chrono::steady_clock;

double megabytes(std::int64_t bytes) {
  return static_cast<double>(bytes) / 1e6;
}

// Runs `make`. Prints its time, the memory it left reserved, and its peak above the start.
template <class Make>
auto measured(const char* what, const Make& make) {
  const std::int64_t before = live_bytes;
  most_bytes = before;
  const Clock::time_point start = Clock::now();
  auto made = make();
  const double milliseconds =
      std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  std::printf("%-16s %9.1f ms   left %8.2f MB   at most %8.2f MB\n", what, milliseconds,
              megabytes(live_bytes - before), megabytes(most_bytes - before));
  return made;
}

void print_spread(const char* what, std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  std::printf("%-28s least %7.3f   quartiles %7.3f %7.3f %7.3f   most %7.3f ms\n", what, at(0),
              at(0.25), at(0.5), at(0.75), at(1));
}

// Pages that the system has handed out so far.
long page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

// Moves to random alphas below `high` (Å²). Each result is freed before the next move.
void measure_moves(const Filtration& filtration, double high, int moves) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> alphas(0, high);
  std::vector<double> times, of_processors;
  std::size_t simplices = 0;
  const long faults = page_faults();
  for (int n = 0; n < moves; ++n) {
    const double alpha = filtration.balls().lattice.alpha_on_lattice(alphas(random)).nearest();
    const std::clock_t worked = std::clock();
    const Clock::time_point start = Clock::now();
    const AlphaComplex complex = threshold(filtration, alpha, false);
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    of_processors.push_back(1e3 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
    simplices += complex.tetrahedra.size();
  }
  char what[64];
  std::snprintf(what, sizeof what, "moves below %g Å²", high);
  print_spread(what, times);
  print_spread("  time of processors", of_processors);
  std::printf("%28s per move: %zu tetrahedra, %ld new pages\n", "",
              simplices / static_cast<std::size_t>(moves), (page_faults() - faults) / moves);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s FILE.balls|FILE.xyzr [THREADS [MOVES [verify]]]\n", argv[0]);
    return 2;
  }
  const auto balls = std::make_shared<const BallSet>(bench::read_balls(argv[1]));
  const int threads = argc > 2 ? static_cast<int>(std::strtol(argv[2], nullptr, 10)) : 1,
            moves = argc > 3 ? static_cast<int>(std::strtol(argv[3], nullptr, 10)) : 200;
  tbb::task_arena arena(threads);
  arena.execute([&] {
    const Triangulation triangulation =
        measured("triangulation", [&] { return make_triangulation(*balls, threads); });
    std::printf("%zu balls, %zu tetrahedra, %zu facets of the hull, %zu hidden\n", balls->size(),
                triangulation.tetrahedra.size(), triangulation.hull.size(),
                triangulation.hidden.size());
    if (argc > 4 && std::strcmp(argv[4], "verify") == 0) {
      const Verification proof =
          measured("proof", [&] { return verify_triangulation(*balls, triangulation); });
      std::printf("%zu checks, %s\n", proof.checks,
                  proof.ok() ? "all hold" : proof.messages[0].c_str());
    }
    const auto estimated = [](const char* what, const MemoryNeed& need) {
      std::printf("%-16s %12s   left %8.2f MB   at most %8.2f MB\n", what, "estimated",
                  megabytes(static_cast<std::int64_t>(need.held)),
                  megabytes(static_cast<std::int64_t>(need.peak)));
    };
    estimated("triangulation", triangulation_memory(balls->size()));
    estimated("filtration", filtration_memory(balls->size()));
    estimated("of these", filtration_memory(triangulation));
    const Filtration filtration =
        measured("filtration", [&] { return Filtration(balls, triangulation); });
    if (moves == 0) return;
    for (const double high : {3.0, 10.0, 100.0}) measure_moves(filtration, high, moves);
  });
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
