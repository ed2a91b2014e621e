// SPDX-License-Identifier: GPL-3.0-or-later
// Compares every predicate and filter with GMP on random, nearly degenerate and extreme balls
// (tests/support/reference/predicate_check.hpp). Prints the numbers of calls, undecided filters and
// ties, and the first wrong answer with its balls. Exit status 1 if there is one.
//
//   alphascope_predicate_check CALLS SEED [THREADS]     e.g. 1e8 1
//   alphascope_predicate_check --number NUMBER SEED     only the balls of this number
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include "tests/support/reference/predicate_check.hpp"

namespace {

using alphascope::testing::PredicateCheck;

// Each thread takes every `threads`-th number. It stops at its share of the calls, or at a wrong
// answer.
PredicateCheck run(double calls, std::uint64_t seed, unsigned threads) {
  std::vector<PredicateCheck> checks(threads, PredicateCheck(seed));
  std::vector<std::thread> workers;
  for (unsigned t = 0; t < threads; ++t) {
    workers.emplace_back([&, t] {
      PredicateCheck& own = checks[t];
      for (std::uint64_t n = t; own.failure().empty(); n += threads) {
        own.check(n);
        // Sixteen at once, the number of kinds of balls.
        if (n / threads % 16 == 15 && static_cast<double>(own.calls()) >= calls / threads) break;
      }
    });
  }
  for (std::thread& worker : workers) worker.join();
  PredicateCheck all(seed);
  for (const PredicateCheck& check : checks) all.add(check);
  return all;
}

int report(const PredicateCheck& check, double seconds) {
  std::printf("%-34s %14s %12s %10s %8s\n", "predicate", "calls", "undecided", "ties", "wrong");
  for (const auto& [name, c] : check.counts()) {
    std::printf("%-34s %14" PRIu64 " %12" PRIu64 " %10" PRIu64 " %8" PRIu64 "\n", name.c_str(),
                c.calls, c.undecided, c.ties, c.wrong);
  }
  std::printf("%-34s %14" PRIu64 " %12s %10s %8" PRIu64 "   in %.0f s\n", "all", check.calls(), "",
              "", check.wrong(), seconds);
  if (check.failure().empty()) return 0;
  std::printf("first wrong answer: %s\n", check.failure().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || (std::strcmp(argv[1], "--number") == 0 && argc < 4)) {
    std::fprintf(stderr,
                 "usage: alphascope_predicate_check CALLS SEED [THREADS]\n"
                 "       alphascope_predicate_check --number NUMBER SEED\n");
    return 2;
  }
  if (std::strcmp(argv[1], "--number") == 0) {
    PredicateCheck one(std::strtoull(argv[3], nullptr, 10));
    one.check(std::strtoull(argv[2], nullptr, 10));
    return report(one, 0);
  }
  const unsigned threads =
      argc > 3
          ? static_cast<unsigned>(std::max(1, static_cast<int>(std::strtol(argv[3], nullptr, 10))))
          : std::max(1u, std::thread::hardware_concurrency());
  const auto start = std::chrono::steady_clock::now();
  const PredicateCheck all =
      run(std::strtod(argv[1], nullptr), std::strtoull(argv[2], nullptr, 10), threads);
  return report(all,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}
