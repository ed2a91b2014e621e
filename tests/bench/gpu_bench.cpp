// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and times the CUDA engine on a machine with a GPU. It first checks that results equal the
// CPU engine's byte for byte, then prints medians. Usage: alphascope_gpu_bench DATA WORDS. WORDS
// are any of check, time, huge, cgal (with time), only (no whole complex), drag:NAME, samples:NAME,
// hashes:NAME or one:NAME:ALPHA[:SOLVENT]. chunks:N before them sets the number of chunks.
// device_compare reads samples and hashes. Inputs are .balls files (make_balls.py), so the program
// needs only the CUDA driver and libtbb.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/support/device_engine.hpp"

using namespace alphascope;

namespace {

template <int N>
bool same(const SimplexList<N>& a, const SimplexList<N>& b) {
  return a.simplices == b.simplices && a.classes == b.classes &&
         a.alpha_values.size() == b.alpha_values.size() &&
         (a.alpha_values.empty() || std::memcmp(a.alpha_values.data(), b.alpha_values.data(),
                                                a.alpha_values.size() * 4) == 0);
}
bool same(const AlphaComplex& a, const AlphaComplex& b) {
  return same(a.vertices, b.vertices) && same(a.edges, b.edges) && same(a.triangles, b.triangles) &&
         same(a.tetrahedra, b.tetrahedra);
}

int failures = 0;
bool with_cgal = false, with_whole = true;
int chunks = 0;  // GpuOptions::chunks

void check(const std::string& name, const BallSet& balls, double solvent,
           const std::vector<double>& alphas) {
  auto grown = std::make_shared<BallSet>(with_solvent(balls, solvent));
  std::string why;
  auto gpu = testing::make_device_engine(grown, &why, {chunks});
  if (!gpu) {
    std::printf("no gpu engine: %s\n", why.c_str());
    std::exit(2);
  }
  auto cpu = make_cpu_engine(grown, {});
  for (const double alpha : alphas) {
    for (const bool only : {true, false}) {
      const AlphaComplex a = gpu->compute({alpha, only}, {}), b = cpu->compute({alpha, only}, {});
      const bool ok = same(a, b);
      failures += !ok;
      if (!ok || balls.size() > 2000) {
        std::printf("%s %s s=%g a=%g %s: V %zu/%zu E %zu/%zu F %zu/%zu T %zu/%zu  %s\n",
                    ok ? "ok  " : "DIFF", name.c_str(), solvent, alpha, only ? "tets" : "whole",
                    a.vertices.size(), b.vertices.size(), a.edges.size(), b.edges.size(),
                    a.triangles.size(), b.triangles.size(), a.tetrahedra.size(),
                    b.tetrahedra.size(), a.engine.route.c_str());
      }
    }
  }
}

void random_checks() {
  std::mt19937 rng(1);
  for (int round = 0; round < 60; ++round) {
    BallSet balls;
    const int n = round < 6 ? round : 20 + round * 5, side = round % 3 == 0   ? 8
                                                             : round % 3 == 1 ? 40
                                                                              : 3000;
    std::uniform_int_distribution<int> at(-side, side), radius(1, std::max(2, side / 2));
    for (int i = 0; i < n; ++i) {
      balls.centres.push_back({at(rng), at(rng), at(rng)});
      balls.radii.push_back(radius(rng));
    }
    const double u = 1e-6 * side * side;
    check("random " + std::to_string(round), balls, 0, {-0.1 * u, 0, 0.05 * u, 0.25 * u, u, 1e-6});
  }
  BallSet cubic;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) {
        cubic.centres.push_back({1000 * x, 1000 * y, 1000 * z});
        cubic.radii.push_back(600);
      }
  check("cubic lattice", cubic, 0, {0, 0.14, 0.39, 0.5, 1});
}

// CGAL's own route to the tetrahedra, triangulation and filter, each time from the start (median in
// ms).
double time_cgal(const std::shared_ptr<const BallSet>& balls, double alpha, int threads) {
  std::vector<double> t;
  for (int run = 0; run < (balls->size() > 200000 ? 1 : 5); ++run) {
    t.push_back(
        make_cgal_engine(balls, {threads})->compute({alpha, true}, {}).timings.wall_milliseconds);
  }
  std::sort(t.begin(), t.end());
  return t[t.size() / 2];
}

// Median time in ms until the program has the result in its own arrays, while it shows the previous
// one.
double time_engine(const BallSet& balls, double alpha, bool only, int runs) {
  const auto engine =
      testing::make_device_engine(std::make_shared<const BallSet>(balls), nullptr, {chunks});
  AlphaComplex shown;
  std::vector<double> t;
  for (int i = 0; i < runs + 3; ++i) {
    AlphaComplex next = engine->compute({alpha, only}, {});
    if (i >= 3) t.push_back(next.timings.wall_milliseconds);
    shown = std::move(next);
  }
  std::sort(t.begin(), t.end());
  return t[t.size() / 2];
}

// The slider moves alpha from 0 to 10 Å² in a hundred steps, each to a new value.
void time_drag(const std::string& name, const BallSet& balls) {
  for (const bool only : {true, false}) {
    const auto engine =
        testing::make_device_engine(std::make_shared<const BallSet>(balls), nullptr, {chunks});
    AlphaComplex shown = engine->compute({0, only}, {});
    const double first = shown.timings.wall_milliseconds;
    std::vector<double> t;
    for (int move = 1; move <= 100; ++move) {
      const auto start = std::chrono::steady_clock::now();
      shown = engine->compute({move * 0.1, only}, {});
      t.push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
              .count());
    }
    std::sort(t.begin(), t.end());
    std::printf(
        "DRAG %-6s %-5s first %.3f ms, median of the others %.3f, the ten slowest from %.3f to "
        "%.3f\n",
        name.c_str(), only ? "tets" : "whole", first, t[t.size() / 2], t[t.size() - 10], t.back());
    std::fflush(stdout);
  }
}

void time_one(const std::string& name, const BallSet& balls, double solvent, double alpha) {
  const BallSet grown = with_solvent(balls, solvent);
  if (with_cgal && grown.size() < 4000000) {
    const auto shared = std::make_shared<const BallSet>(grown);
    std::printf("CGAL %-6s n=%zu s=%g a=%g tets 1 thread %.1f ms, 16 threads %.1f ms\n",
                name.c_str(), grown.size(), solvent, alpha, time_cgal(shared, alpha, 1),
                time_cgal(shared, alpha, 16));
  }
  gpu::DualEdgePipeline pipeline(grown, chunks);
  const double a = grown.lattice.alpha_on_lattice(alpha).nearest();
  for (const bool only : {true, false}) {
    if (!only && !with_whole) continue;
    gpu::PipelineResult r;
    for (int w = 0; w < 3; ++w) r = pipeline.run(a, only, {}, nullptr);
    if (!r.fits) {
      std::printf("%s does not fit\n", name.c_str());
      continue;
    }
    std::vector<double> t;
    const int runs = grown.size() > 4000000 ? 5 : 21;
    for (int i = 0; i < runs; ++i) {
      const auto start = std::chrono::steady_clock::now();
      r = pipeline.run(a, only, {}, nullptr);
      t.push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
              .count());
    }
    std::sort(t.begin(), t.end());
    StageTimes stages;
    pipeline.run(a, only, {}, &stages);
    stages = {};
    pipeline.run(a, only, {}, &stages);
    std::printf(
        "TIME %-6s n=%zu s=%g a=%g %-5s median %.3f ms min %.3f | T=%zu E=%zu exact balls %u |",
        name.c_str(), grown.size(), solvent, alpha, only ? "tets" : "whole", t[t.size() / 2], t[0],
        r.tetrahedra.simplices.size(), r.edges.simplices.size(), r.exact_balls);
    for (const auto& s : stages.stages) std::printf(" %s %.3f;", s.label.c_str(), s.milliseconds);
    std::printf(" in the program %.3f\n", time_engine(grown, alpha, only, runs));
    std::fflush(stdout);
  }
}

double milliseconds_of(const std::function<void()>& what) {
  const auto start = std::chrono::steady_clock::now();
  what();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

void print_samples(const std::string& row, const char* what, const std::vector<double>& times) {
  std::printf("SAMPLE %s %s", row.c_str(), what);
  for (const double t : times) std::printf(" %.4f", t);
  std::printf("\n");
}

constexpr double kSampledAlphas[] = {0, 1.4, 10};
std::string row_of(const std::string& name, double alpha, bool only) {
  std::ostringstream row;
  row << name << ' ' << alpha << ' ' << (only ? "tets" : "whole");
  return row.str();
}
void print_hash(const std::string& row, std::uint64_t hash) {
  std::printf("HASH %s %016llx\n", row.c_str(), static_cast<unsigned long long>(hash));
}

// Prints the CPU engine's hashes for comparison with samples().
void hashes(const std::string& name, const BallSet& balls) {
  const auto engine = make_cpu_engine(std::make_shared<const BallSet>(balls), {});
  for (const double alpha : kSampledAlphas) {
    for (const bool only : {true, false}) {
      print_hash(row_of(name, alpha, only), engine->compute({alpha, only}, {}).hash);
    }
  }
}

// Prints every single time, ms, so that two builds can be timed in turns. It times taking the
// balls, a set's first run and the same run again. It also times 40 moves of the slider from 0 to
// 10 Å². Also prints how many attempts the first run took until there was room.
void samples(const std::string& name, const BallSet& balls) {
  constexpr int kFirst = 5, kAgain = 6, kWarmUp = 3, kMoves = 40;
  for (const double alpha : kSampledAlphas) {
    const double a = balls.lattice.alpha_on_lattice(alpha).nearest();
    for (const bool only : {true, false}) {
      const std::string row = row_of(name, alpha, only);
      std::vector<double> load, first, again;
      gpu::PipelineResult result;
      for (int i = 0; i <= kFirst; ++i) {  // the first one is not counted
        std::unique_ptr<gpu::DualEdgePipeline> pipeline;
        result = {};
        const double loading = milliseconds_of(
            [&] { pipeline = std::make_unique<gpu::DualEdgePipeline>(balls, chunks); });
        const auto run = [&] { result = pipeline->run(a, only, {}, nullptr); };
        const double running = milliseconds_of(run);
        if (i > 0) load.push_back(loading), first.push_back(running);
        if (i == kFirst) {
          print_hash(row, result.hash.combined(only));
          std::printf("ATTEMPTS %s %d\n", row.c_str(), result.attempts);
          for (int w = 0; w < kWarmUp; ++w) run();
          for (int r = 0; r < kAgain; ++r) again.push_back(milliseconds_of(run));
          print_hash(row, result.hash.combined(only));
        }
      }
      print_samples(row, "load", load);
      print_samples(row, "first", first);
      print_samples(row, "again", again);
    }
  }
  for (const bool only : {true, false}) {
    gpu::DualEdgePipeline pipeline(balls, chunks);
    gpu::PipelineResult result = pipeline.run(0, only, {}, nullptr);
    std::vector<double> moves;
    for (int move = 1; move <= kMoves; ++move) {
      const double a = balls.lattice.alpha_on_lattice(10.0 * move / kMoves).nearest();
      moves.push_back(milliseconds_of([&] { result = pipeline.run(a, only, {}, nullptr); }));
    }
    print_samples(name + (only ? " 0-10 tets" : " 0-10 whole"), "moved", moves);
  }
  std::fflush(stdout);
}

// The folder with the inputs.
struct Data {
  std::string folder;
  BallSet balls(const std::string& name) const {
    return bench::read_balls(folder + "/" + name + ".balls");
  }
};

void check_all(const Data& data) {
  random_checks();
  std::printf("random: %d differences\n", failures);
  for (const char* name : {"1grm", "1k4c", "1aon", "2buk"}) {
    const BallSet balls = data.balls(name);
    check(name, balls, 0, {-1, 0, 0.5, 1.4, 3, 10});
    check(name, balls, 1.4, {0, 1.4});
  }
  std::printf("checks: %d differences\n", failures);
}

void time_all(const Data& data) {
  for (const char* name : {"1k4c", "1aon", "3j6r"}) {
    const BallSet balls = data.balls(name);
    for (const double alpha : {0.0, 1.4, 3.0, 10.0}) time_one(name, balls, 0, alpha);
    time_one(name, balls, 1.4, 0);
  }
}

void time_huge(const Data& data) {
  const BallSet balls = data.balls("1m4x");
  for (const double alpha : {0.0, 1.4}) time_one("1m4x", balls, 0, alpha);
}

// Times a row NAME:ALPHA or NAME:ALPHA:SOLVENT.
void time_row(const Data& data, const std::string& row) {
  std::istringstream parts(row);
  std::string name, alpha, solvent = "0";
  std::getline(parts, name, ':');
  std::getline(parts, alpha, ':');
  std::getline(parts, solvent);
  time_one(name, data.balls(name), std::stod(solvent), std::stod(alpha));
}

}  // namespace

int main(int argc, char** argv) {
  const Data data{argc > 1 ? argv[1] : "."};
  std::vector<std::string> words;
  std::istringstream list(argc > 2 ? argv[2] : "check,time");
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  const auto asked = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  with_cgal = asked("cgal");
  with_whole = !asked("only");
  const auto& d = gpu_device();
  std::printf("device: %s usable %d %s %s\n", d.name.c_str(), d.usable, d.driver.c_str(),
              d.why_not.c_str());
  if (asked("check")) check_all(data);
  if (asked("time")) time_all(data);
  if (asked("huge")) time_huge(data);
  for (const std::string& word : words) {
    if (word.starts_with("chunks:")) chunks = std::stoi(word.substr(7));
    if (word.starts_with("drag:")) time_drag(word.substr(5), data.balls(word.substr(5)));
    if (word.starts_with("samples:")) samples(word.substr(8), data.balls(word.substr(8)));
    if (word.starts_with("hashes:")) hashes(word.substr(7), data.balls(word.substr(7)));
    if (word.starts_with("one:")) time_row(data, word.substr(4));
  }
  return failures == 0 ? 0 : 1;
}
