// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and times the tuple engine on a machine with a GPU. Usage:
//   alphascope_tuple_gpu_check [FILE.balls|FILE.xyzr]...
// Random and degenerate sets come first, then each file. Every combination of switches must equal
// the CPU's dual-edge engine byte for byte. Counters must equal those of the CPU's tuple engine,
// and repeated runs each other. For each file, times of the stages are printed for every switch.
// Exit code 1 when anything differs, 2 without a device.
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "core/tuples/tuple_engine.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/tuples/tuple_engine.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/bench/times.hpp"

using namespace alphascope;

namespace {

using Balls = std::shared_ptr<const BallSet>;

int compared = 0, failures = 0;

template <int N>
bool same(const SimplexList<N>& a, const SimplexList<N>& b) {
  return a.simplices == b.simplices && a.classes == b.classes &&
         a.alpha_values.size() == b.alpha_values.size() &&
         (a.alpha_values.empty() || std::memcmp(a.alpha_values.data(), b.alpha_values.data(),
                                                a.alpha_values.size() * sizeof(float)) == 0);
}
bool same(const AlphaComplex& a, const AlphaComplex& b) {
  return same(a.vertices, b.vertices) && same(a.edges, b.edges) && same(a.triangles, b.triangles) &&
         same(a.tetrahedra, b.tetrahedra) && a.hash == b.hash;
}

void expect(bool good, const std::string& what) {
  ++compared;
  if (good) return;
  ++failures;
  std::printf("DIFFERS %s\n", what.c_str());
}

std::string name_of(const TupleOptions& o) {
  return std::string(o.grid == TupleGridKind::thesis ? "grid 100, " : "grid auto, ") +
         (o.edge_optimisation ? "edge, " : "no edge, ") +
         (o.alpha_optimisation ? "alpha, " : "no alpha, ") +
         (o.pinned ? "pinned, " : "pageable, ") + std::to_string(o.streams) + " streams, " +
         (o.texture ? "texture" : "no texture") +
         (o.tuples_per_batch > 0 ? ", batches of " + std::to_string(o.tuples_per_batch) : "");
}

std::vector<TupleOptions> all_switches() {
  std::vector<TupleOptions> all;
  for (int bits = 0; bits < 128; ++bits) {
    TupleOptions o;
    o.grid = bits & 1 ? TupleGridKind::thesis : TupleGridKind::automatic;
    o.edge_optimisation = !(bits & 2);
    o.alpha_optimisation = !(bits & 4);
    o.pinned = !(bits & 8);
    o.streams = bits & 16 ? 1 : 3;
    o.texture = !(bits & 32);
    o.tuples_per_batch = bits & 64 ? 3000 : 0;
    all.push_back(o);
  }
  return all;
}

std::unique_ptr<Engine> gpu_engine(const Balls& balls, const TupleOptions& options) {
  std::string why_not;
  auto engine = make_gpu_tuple_engine(balls, options, &why_not);
  if (!engine) {
    std::printf("no tuple engine: %s\n", why_not.c_str());
    std::exit(2);
  }
  return engine;
}

void check(const std::string& name, const Balls& balls, const std::vector<double>& alphas,
           const std::vector<TupleOptions>& switches) {
  const auto dual_edges = make_cpu_engine(balls);
  std::vector<AlphaRequest> requests;
  std::vector<AlphaComplex> expected;
  for (const double alpha : alphas) {
    for (const bool only : {false, true}) {
      requests.push_back({alpha, only});
      expected.push_back(dual_edges->compute(requests.back(), {}));
    }
  }
  for (const TupleOptions& o : switches) {
    const auto engine = gpu_engine(balls, o);  // making an engine takes longer than asking it
    for (std::size_t r = 0; r < requests.size(); ++r) {
      const std::string what = name + ", alpha " + std::to_string(requests[r].alpha_angstrom2) +
                               (requests[r].tetrahedra_only ? ", tetrahedra only: " : ": ") +
                               name_of(o);
      const AlphaComplex found = engine->compute(requests[r], {});
      expect(same(found, expected[r]), what);
      expect(same(engine->compute(requests[r], {}), found), what + ", second run");
    }
  }
}

// Compares all counters but the number of batches, which depends on the executor.
void check_counters(const std::string& name, const Balls& balls, double alpha) {
  for (const bool edge : {true, false}) {
    TupleOptions o;
    o.edge_optimisation = edge;
    const auto on_gpu = gpu_engine(balls, o)->compute({alpha}, {}).engine.counters;
    const auto on_cpu = make_tuple_engine(balls, {}, o)->compute({alpha}, {}).engine.counters;
    for (std::size_t c = 0; c + 1 < on_gpu.size(); ++c) {
      expect(on_gpu[c].value == on_cpu[c].value,
             name + ": " + on_gpu[c].name + " " + std::to_string(on_gpu[c].value) +
                 ", on the CPU " + std::to_string(on_cpu[c].value));
    }
  }
}

Balls random_set(std::mt19937& random, int count, int side, int most_radius) {
  auto balls = std::make_shared<BallSet>();
  balls->lattice.digits = 0;
  std::uniform_int_distribution<int> at(-side, side), radius(1, most_radius);
  for (int n = 0; n < count; ++n) {
    balls->centres.push_back({at(random), at(random), at(random)});
    balls->radii.push_back(radius(random));
  }
  return balls;
}

void check_small_sets() {
  std::mt19937 random(7);
  const auto switches = all_switches();
  for (int round = 0; round < 2; ++round) {
    const std::string number = std::to_string(round);
    check("few " + number, random_set(random, 4 * round, 4, 3), {0, 9}, switches);
    check("coarse " + number, random_set(random, 40, 4, 3), {-1, 0, 2, 30}, switches);
    check("dense " + number, random_set(random, 30, 1, 3), {0, 1}, switches);
    check("random " + number, random_set(random, 60, 1000, 400), {0, 1e5}, switches);
    check("huge " + number, random_set(random, 25, 500000000, 60000000), {0, 1e17}, switches);
  }
  check_counters("random set", random_set(random, 200, 1000, 300), 1e4);
  std::printf("small sets: %d comparisons, %d differences\n", compared, failures);
}

using bench::median;

// Medians of the whole answer as its caller waits for it, and the stages of the last run.
void time_one(const std::string& name, const Balls& balls, double alpha, bool only,
              const TupleOptions& o) {
  const auto engine = gpu_engine(balls, o);
  std::vector<double> wall;
  AlphaComplex complex;
  for (int run = 0; run < 8; ++run) {
    complex = engine->compute({alpha, only}, {});
    if (run >= 3) wall.push_back(complex.timings.wall_milliseconds);
  }
  std::printf("TIME %s n=%zu alpha %g %s | %s | %.3f ms |", name.c_str(), balls->size(), alpha,
              only ? "tetrahedra" : "whole", name_of(o).c_str(), median(wall));
  for (const StageTime& s : complex.timings.stages) {
    std::printf(" %s %.3f;", s.label.c_str(), s.milliseconds);
  }
  std::printf(" |");
  for (const EngineCounter& c : complex.engine.counters) {
    std::printf(" %s %llu;", c.name.c_str(), static_cast<unsigned long long>(c.value));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void time_switches(const std::string& name, const Balls& balls, double alpha) {
  std::vector<TupleOptions> list(9);
  list[1].texture = false;
  list[2].pinned = false;
  list[3].streams = 1;
  list[4].streams = 4;
  list[5].grid = TupleGridKind::thesis;
  list[6].alpha_optimisation = false;
  list[7].edge_optimisation = false;
  list[8] = {TupleGridKind::automatic, false, false, false, 1, false, 0};
  for (const TupleOptions& o : list) time_one(name, balls, alpha, true, o);
  time_one(name, balls, alpha, false, list[0]);
}

void run_file(const std::string& path) {
  const auto balls = std::make_shared<const BallSet>(bench::read_balls(path));
  const std::string name = path.substr(path.find_last_of('/') + 1);
  TupleOptions bare{TupleGridKind::thesis, false, false, false, 1, false, 0};
  TupleOptions plain{TupleGridKind::automatic, true, true, true, 1, false, 0};
  check(name, balls, {-1, 0, 1.4}, {TupleOptions{}, bare, plain});
  const auto grown = std::make_shared<const BallSet>(with_solvent(*balls, 1.4));
  check(name + ", solvent 1.4", grown, {0}, {TupleOptions{}, plain});
  check_counters(name, balls, 0);
  std::printf("%s: %d comparisons so far, %d differences\n", name.c_str(), compared, failures);
  for (const double alpha : {0.0, 1.4}) time_switches(name, balls, alpha);
  for (const double alpha : {3.0, 10.0}) time_one(name, balls, alpha, true, {});
  time_one(name + ", solvent 1.4", grown, 0, true, {});
}

}  // namespace

int main(int argc, char** argv) {
  const GpuDevice& device = gpu_device();
  if (!device.usable) {
    std::printf("%s\n", device.why_not.c_str());
    return 2;
  }
  std::printf("%s, %s\n", device.name.c_str(), device.driver.c_str());
  check_small_sets();
  for (int a = 1; a < argc; ++a) run_file(argv[a]);
  std::printf("%d comparisons, %d differences\n", compared, failures);
  return failures == 0 ? 0 : 1;
}
