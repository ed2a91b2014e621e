// SPDX-License-Identifier: GPL-3.0-or-later
// Compares cavities with the tables of an independent program, and times each of our steps.
//
//   alphascope_cavity_check FOLDER [THREADS [INPUT [REPETITIONS]]]
//   alphascope_cavity_check FILE SOLVENT_Å [THREADS [REPETITIONS]]      any molecule
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"
#include "tests/support/reference/cavity_reference.hpp"

namespace {

using namespace alphascope;

// Times of each step. On a shared machine CPU times are more reliable.
class Steps {
 public:
  template <class Make>
  auto time(const std::string& step, const Make& make) {
    using Clock = std::chrono::steady_clock;
    const std::clock_t worked = std::clock();
    const Clock::time_point start = Clock::now();
    auto made = make();
    Times& times = times_[step];
    if (times.wall.empty()) order_.push_back(step);
    times.wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    times.of_processors.push_back(1e3 * static_cast<double>(std::clock() - worked) /
                                  CLOCKS_PER_SEC);
    return made;
  }
  void print() {
    for (const std::string& step : order_) {
      Times& times = times_[step];
      std::sort(times.wall.begin(), times.wall.end());
      std::sort(times.of_processors.begin(), times.of_processors.end());
      std::printf("    %-28s median %8.2f, least %8.2f ms; of processors: least %8.2f ms\n",
                  step.c_str(), times.wall[times.wall.size() / 2], times.wall[0],
                  times.of_processors[0]);
    }
  }

 private:
  struct Times {
    std::vector<double> wall, of_processors;  // ms
  };
  std::map<std::string, Times> times_;
  std::vector<std::string> order_;
};

struct Answer {
  CavityGround ground;
  Cavities cavities;
  std::vector<CavityMeasures> measures;
};

struct Balls {
  std::shared_ptr<const BallSet> balls;
  double solvent;  // the growth of the balls, lattice units
  bool clip = false;
};
Balls grown(std::shared_ptr<const BallSet> balls, double solvent_angstrom) {
  const double solvent = balls->lattice.nearest_units(solvent_angstrom);
  return {std::move(balls), solvent, false};
}

Answer compute(const Balls& given, int threads, Steps& steps) {
  const auto triangulation = std::make_shared<const Triangulation>(
      steps.time("triangulation", [&] { return make_triangulation(*given.balls, threads); }));
  const auto& balls = given.balls;
  CavityGround ground{balls, triangulation, {}, {}};
  ground.incidence = steps.time("incidence", [&] { return make_incidence(*triangulation); });
  ground.flow =
      steps.time("flow", [&] { return make_flow(*balls, *triangulation, FlowTies::perturbed); });
  if (triangulation->dimension < 3) return {std::move(ground), {}, {}};
  const Membership in = steps.time("membership", [&] {
    return membership(*balls, *triangulation, ground.incidence, ground.flow, 0);
  });
  Cavities cavities = steps.time("cavities", [&] { return find_cavities(ground, in); });
  auto measures = steps.time("measures", [&] {
    return measure_cavities(ground, in, cavities, {0, given.solvent});
  });
  std::vector<std::uint32_t> all(measures.size());
  std::iota(all.begin(), all.end(), 0u);
  if (given.clip) {
    steps.time("exact volumes", [&] { return measure_cavities_exactly(ground, cavities, all, 0); });
  }
  return {std::move(ground), std::move(cavities), std::move(measures)};
}

void compute_all(const Balls& balls, int threads, int repetitions) {
  Steps steps;
  for (int n = 0; n < repetitions; ++n) {
    const Answer answer =
        steps.time("from balls to the table", [&] { return compute(balls, threads, steps); });
    if (n > 0) continue;
    std::size_t voids = 0;
    for (const Cavity& cavity : answer.cavities.cavities) voids += cavity.is_void();
    std::printf("  %zu balls, %zu tetrahedra, %zu voids, %zu pockets\n", balls.balls->size(),
                answer.ground.triangulation->tetrahedra.size(), voids,
                answer.cavities.cavities.size() - voids);
  }
  Balls clipped = balls;
  clipped.clip = true;
  compute(clipped, threads, steps);
  steps.print();
}

int check(const std::string& folder, int threads, const std::string& only, int repetitions) {
  const testing::CavityReference reference(folder);
  int wrong = 0, runs = 0;
  for (const testing::TableRow& run : reference.runs()) {
    if (!only.empty() && run.at("input") != only) continue;
    const Balls balls = grown(reference.balls(run), std::stod(run.at("solvent")));
    Steps steps;
    const Answer answer = compute(balls, threads, steps);
    const auto differences =
        reference.differences(run, answer.ground, answer.cavities, answer.measures);
    for (const std::string& difference : differences) std::printf("%s\n", difference.c_str());
    ++runs;
    wrong += !differences.empty();
    if (repetitions == 0) continue;
    std::printf("%s, solvent %s\n", run.at("input").c_str(), run.at("solvent").c_str());
    compute_all(balls, threads, repetitions);
  }
  std::printf("%d runs, %d differ\n", runs, wrong);
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: %s FOLDER [THREADS [INPUT [REPETITIONS]]]\n"
                 "       %s FILE SOLVENT [THREADS [REPETITIONS]]\n",
                 argv[0], argv[0]);
    return 2;
  }
  const auto number = [&](int n, int otherwise) {
    return argc > n ? std::atoi(argv[n]) : otherwise;
  };
  if (std::filesystem::is_directory(argv[1])) {
    const int threads = number(2, 1);
    return tbb::task_arena(threads).execute(
        [&] { return check(argv[1], threads, argc > 3 ? argv[3] : "", number(4, 0)); });
  }
  const double solvent = argc > 2 ? std::atof(argv[2]) : 0;
  const Balls balls = grown(std::make_shared<const BallSet>(with_solvent(
                                *prepare_balls(read_molecule(argv[1])).balls, solvent)),
                            solvent);
  const int threads = number(3, 1);
  tbb::task_arena(threads).execute([&] { compute_all(balls, threads, number(4, 5)); });
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
