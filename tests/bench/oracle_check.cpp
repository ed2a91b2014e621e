// SPDX-License-Identifier: GPL-3.0-or-later
// Compares every CPU engine with the oracle in rationals on small sets, and with CGAL's engine on
// larger ones. It runs for the given time. Sets are degenerate, random, lattices, grazing, and at
// the bounds of the lattice, with 3 to 6 digits (tests/support/random_balls.hpp). Prints how much
// was compared, and the first difference with its balls. Exit status 1 if there is one.
//
//   alphascope_oracle_check SECONDS SEED     e.g. 3600 1
//   alphascope_oracle_check --round ROUND SEED     only this round
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "core/run/cancel_token.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/reference/oracle_check.hpp"

namespace {

using namespace alphascope;
using namespace alphascope::testing;

// Counts of each engine.
struct Counts {
  OracleCounts oracle, cgal;
};

class OracleCheck {
 public:
  explicit OracleCheck(std::uint64_t seed) : seed_(seed) {}

  // Compares the sets of all families once. Returns false at the first difference.
  bool round(std::uint64_t number) {
    Random random(seed_ * 0x9e3779b97f4a7c15 + number);
    const int most = random_int(random, 4, 11);
    for (const NamedBalls& set : small_hard_sets(random, most)) {
      if (!small_set(random, set)) return fail(number);
    }
    for (const NamedBalls& set : sets_at_the_bounds(random, most)) {
      if (!small_set(random, set)) return fail(number);
    }
    for (const NamedBalls& set : large_hard_sets(random, random_int(random, 20, 200))) {
      if (!large_set(random, set)) return fail(number);
    }
    ++rounds_;
    return true;
  }

  void report(double seconds) const {
    std::printf("%" PRIu64 " rounds, %" PRIu64 " small and %" PRIu64 " larger sets, %.0f s\n",
                rounds_, small_sets_, large_sets_, seconds);
    std::printf("%-12s %22s %12s %22s %12s\n", "engine", "complexes, the oracle's", "simplices",
                "complexes, CGAL's", "simplices");
    for (const auto& [name, c] : counts_) {
      std::printf("%-12s %23zu %12zu %22zu %12zu\n", name.c_str(), c.oracle.complexes,
                  c.oracle.simplices, c.cgal.complexes, c.cgal.simplices);
    }
    if (!difference_.empty()) std::printf("first difference: %s\n", difference_.c_str());
  }

 private:
  bool fail(std::uint64_t number) {
    difference_ =
        "seed " + std::to_string(seed_) + ", round " + std::to_string(number) + ", " + difference_;
    return false;
  }

  bool small_set(Random& random, const NamedBalls& set) {
    ++small_sets_;
    const RationalOracle oracle(set.balls);
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const std::vector<double> alphas =
        some_of(random, interesting_alphas(oracle, balls->lattice), 16);
    for (const EngineFactory& factory : engines_) {
      const auto engine = factory.make(balls);
      const std::string what =
          difference_from_oracle(*engine, set, oracle, alphas, counts_[factory.name].oracle);
      if (what.empty()) continue;
      difference_ = factory.name + ", " + what;
      return false;
    }
    return true;
  }

  bool large_set(Random& random, const NamedBalls& set) {
    ++large_sets_;
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const auto reference = make_cgal_engine(balls, {1});
    for (const double share : {-1.0, 0.0, 0.25 * random_int(random, 1, 40)}) {
      const double alpha = share * set.alpha_unit();
      const AlphaComplex expected = reference->compute({alpha}, {});
      for (const EngineFactory& factory : engines_) {
        if (factory.most_balls < static_cast<int>(balls->size())) continue;
        if (!factory.affords(*balls, alpha)) continue;
        const AlphaComplex found = factory.make(balls)->compute({alpha}, {});
        const std::string what = difference(found, expected);
        if (!what.empty()) {
          difference_ = factory.name + ", " + set.name + ", alpha " + std::to_string(alpha) +
                        " Å²: " + what + list_balls(set.balls);
          return false;
        }
        OracleCounts& counts = counts_[factory.name].cgal;
        ++counts.complexes;
        counts.simplices += found.vertices.size() + found.edges.size() + found.triangles.size() +
                            found.tetrahedra.size();
      }
    }
    return true;
  }

  const std::uint64_t seed_;
  const std::vector<EngineFactory> engines_ = engines();
  std::map<std::string, Counts> counts_;
  std::uint64_t rounds_ = 0, small_sets_ = 0, large_sets_ = 0;
  std::string difference_;
};

}  // namespace

int main(int argc, char** argv) {
  const bool one = argc > 3 && std::strcmp(argv[1], "--round") == 0;
  if (argc < 3 || (argc > 3 && !one)) {
    std::fprintf(stderr,
                 "usage: alphascope_oracle_check SECONDS SEED\n"
                 "       alphascope_oracle_check --round ROUND SEED\n");
    return 2;
  }
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  OracleCheck check(std::strtoull(argv[one ? 3 : 2], nullptr, 10));
  bool same = true;
  if (one) {
    same = check.round(std::strtoull(argv[2], nullptr, 10));
  } else {
    const double most = std::strtod(argv[1], nullptr);
    for (std::uint64_t n = 0; same && seconds() < most; ++n) same = check.round(n);
  }
  check.report(seconds());
  return same ? 0 : 1;
}
