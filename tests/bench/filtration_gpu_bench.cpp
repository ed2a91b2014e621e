// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and times filtrations, incidences and flows of whole triangulations on a machine with a
// GPU, and tables of cavities from balls to table. All are compared with the CPU's. Usage:
//   alphascope_filtration_gpu_bench RUNS FILE.balls[:SOLVENT]...
// Times are medians in ms, from arrays in host memory to arrays in host memory, after two runs to
// warm up. The triangulation is the device's, and is still there. The CPU uses all threads.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/wrapping/seed.hpp"
#include "gpu/wrapping/triangulator.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/bench/times.hpp"

using namespace alphascope;

namespace {

using bench::Clock;
using bench::median;
using bench::milliseconds;

bool same_bits(const ResultArray<float>& a, const ResultArray<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}
bool same(const Filtration& a, const Filtration& b) {
  const auto lists = [](const auto& x, const auto& y) {
    return x.simplices == y.simplices && same_bits(x.alpha_values, y.alpha_values) &&
           x.classes == y.classes;
  };
  const auto levels = [](const ClassLevels& x, const ClassLevels& y) {
    return same_bits(x.regular_from, y.regular_from) && same_bits(x.interior_from, y.interior_from);
  };
  return lists(a.top().vertices, b.top().vertices) && lists(a.top().edges, b.top().edges) &&
         lists(a.top().triangles, b.top().triangles) &&
         lists(a.top().tetrahedra, b.top().tetrahedra) &&
         levels(a.levels().vertices, b.levels().vertices) &&
         levels(a.levels().edges, b.levels().edges) &&
         levels(a.levels().triangles, b.levels().triangles) && a.hash_steps() == b.hash_steps();
}
bool same(const CavityGround& a, const CavityGround& b) {
  return a.incidence == b.incidence && a.flow.marks == b.flow.marks &&
         same_bits(a.flow.alpha_values, b.flow.alpha_values) && a.flow.ties == b.flow.ties;
}
bool same(const CavityTable& a, const CavityTable& b) {
  if (!(a.found == b.found) || a.order != b.order) return false;
  for (std::size_t c = 0; c < a.measures.size(); ++c) {
    if (a.measures[c].volume_sa_angstrom3 != b.measures[c].volume_sa_angstrom3 ||
        a.measures[c].area_sa_angstrom2 != b.measures[c].area_sa_angstrom2)
      return false;
  }
  return true;
}

// The median of `runs` calls. `made` is dropped before each, as a program does.
template <class Made, class Make>
double time_of(int runs, std::shared_ptr<const Made>& made, const Make& make) {
  std::vector<double> wall;
  for (int run = 0; run < runs + 2; ++run) {
    made = nullptr;
    const auto start = Clock::now();
    made = make();
    if (run >= 2) wall.push_back(milliseconds(start));
  }
  return median(wall);
}

bool time_set(const std::shared_ptr<TriangulationMaker>& maker, const std::string& name,
              const std::shared_ptr<const BallSet>& balls, double solvent, int runs) {
  const int few = std::max(1, runs / 4);
  TriangulationMaker* const device = maker.get();
  const auto whole =
      std::make_shared<const Triangulation>(make_triangulation_by(maker, *balls, 0, {}));
  std::shared_ptr<const Filtration> filtration, of_cpu;
  const double on_device = time_of(runs, filtration, [&] {
    return std::make_shared<const Filtration>(balls, whole, RunContext{}, device);
  });
  const double on_cpu = time_of(few, of_cpu, [&] {
    return std::make_shared<const Filtration>(balls, whole, RunContext{}, nullptr);
  });
  bool equal = !filtration->device().empty() && same(*filtration, *of_cpu);
  filtration = of_cpu = nullptr;
  std::shared_ptr<const CavityGround> ground, ground_of_cpu;
  const auto make_ground = [&](std::shared_ptr<const Triangulation> of, TriangulationMaker* by) {
    return std::make_shared<const CavityGround>(
        make_cavity_ground(balls, std::move(of), FlowTies::perturbed, RunContext{}, by));
  };
  const double ground_on_device = time_of(runs, ground, [&] { return make_ground(whole, device); });
  const double ground_on_cpu =
      time_of(few, ground_of_cpu, [&] { return make_ground(whole, nullptr); });
  equal = equal && same(*ground, *ground_of_cpu);
  const auto table_of = [&](const std::shared_ptr<TriangulationMaker>& by) {
    auto triangulation =
        std::make_shared<const Triangulation>(make_triangulation_by(by, *balls, 0, {}));
    return std::make_shared<const CavityTable>(make_cavity_table(
        make_ground(std::move(triangulation), by.get()),
        {Alpha{0.0}, solvent, OutsideRule::castp, false}, RunContext{}, by.get()));
  };
  std::shared_ptr<const CavityTable> table, table_of_cpu;
  const double table_alone = time_of(runs, table, [&] {
    return std::make_shared<const CavityTable>(make_cavity_table(
        ground, {Alpha{0.0}, solvent, OutsideRule::castp, false}, RunContext{}, device));
  });
  std::vector<double> marks, search;
  for (int run = 0; run < runs; ++run) {
    const LatticeAlpha alpha = balls->lattice.alpha_on_lattice(Alpha{0.0});
    auto start = Clock::now();
    const auto in = device->membership(ground->incidence, alpha, {});
    marks.push_back(milliseconds(start));
    if (!in) break;
    start = Clock::now();
    const Cavities found = find_cavities(*ground, *in);
    search.push_back(milliseconds(start));
  }
  ground = ground_of_cpu = nullptr;
  const double table_on_device = time_of(runs, table, [&] { return table_of(maker); });
  const double table_on_cpu = time_of(few, table_of_cpu, [&] { return table_of(nullptr); });
  equal = equal && same(*table, *table_of_cpu);
  std::printf(
      "%s %s: balls %zu; filtration %.2f (CPU %.1f); incidences and flow %.2f (CPU %.1f); table "
      "beyond them %.2f (membership %.2f, search %.2f); balls to table, %zu cavities: %.2f (CPU "
      "%.1f)\n",
      equal ? "ok  " : "DIFF", name.c_str(), balls->size(), on_device, on_cpu, ground_on_device,
      ground_on_cpu, table_alone, median(marks), median(search), table->found.cavities.size(),
      table_on_device, table_on_cpu);
  std::fflush(stdout);
  return equal;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: alphascope_filtration_gpu_bench RUNS FILE.balls[:SOLVENT]...\n");
    return 2;
  }
  const auto maker = std::make_shared<TriangulationMaker>(
      [](std::string&) { return make_gpu_triangulator(seed_tetrahedron); });
  WorkThreads threads(0);
  bool equal = true;
  for (int n = 2; n < argc; ++n) {
    const std::string word = argv[n];
    const std::size_t colon = word.rfind(':');
    const double solvent = colon == std::string::npos ? 0 : std::atof(word.c_str() + colon + 1);
    const auto balls = std::make_shared<const BallSet>(bench::read_grown_balls(word));
    threads.run(
        [&] { equal = time_set(maker, word, balls, solvent, std::atoi(argv[1])) && equal; });
  }
  return equal ? 0 : 1;
}
