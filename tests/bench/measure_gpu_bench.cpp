// SPDX-License-Identifier: GPL-3.0-or-later
// Compares areas and volumes on a device with the CPU's: first equality, then medians of times.
//
//   alphascope_measure_gpu_bench [--solvent S] [--alpha A] [--runs N] [--no-cpu] FILES…
//
// FILES are .balls (make_balls.py) or .xyzr. The solvent radius is in Å (1.4), alpha in Å² (0). The
// device computes the complex. Route "there" measures it where the engine left it on the device.
// Route "sent" uploads it from the host, as for complexes computed elsewhere. Times are in
// milliseconds.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/union_measures.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/measure/gpu_measure.hpp"
#include "gpu/measure/union_measurer.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/bench/times.hpp"

namespace {

using namespace alphascope;

constexpr double kNear = 1e-12;  // relative

struct Options {
  double solvent = 1.4, alpha = 0;
  int runs = 15;
  bool cpu = true;
  std::vector<std::string> files;
};

using bench::median;
double milliseconds_of(const std::function<void()>& what) {
  const auto start = std::chrono::steady_clock::now();
  what();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

template <int N>
void keep(const gpu::PipelineResult& result, const gpu::HostSimplices<N>& from,
          SimplexList<N>& to) {
  to.simplices = in_place(result.memory, from.simplices);
  to.alpha_values = in_place(result.memory, from.values);
  to.classes = in_place(result.memory, from.classes);
}
AlphaComplex complex_of(const gpu::PipelineResult& result, const BallSet& balls,
                        const LatticeAlpha& alpha) {
  AlphaComplex complex;
  complex.lattice = balls.lattice;
  complex.alpha_on_lattice = alpha;
  keep(result, result.vertices, complex.vertices);
  keep(result, result.edges, complex.edges);
  keep(result, result.triangles, complex.triangles);
  keep(result, result.tetrahedra, complex.tetrahedra);
  return complex;
}

// Greatest relative differences of the totals, and of balls relative to their spheres and whole
// balls.
struct Differences {
  double area = 0, volume = 0, ball_area = 0, ball_volume = 0;
  bool are_small() const {
    return area <= kNear && volume <= kNear && ball_area <= kNear && ball_volume <= kNear;
  }
};
double relative(double found, double expected) {
  return expected == found ? 0 : std::fabs(found - expected) / std::fabs(expected);
}
Differences differences(const UnionMeasures& found, const UnionMeasures& expected,
                        const BallSet& balls, const LatticeAlpha& alpha) {
  Differences most;
  most.area = relative(found.area_angstrom2(), expected.area_angstrom2());
  most.volume = relative(found.volume_angstrom3(), expected.volume_angstrom3());
  const double unit = balls.lattice.unit_angstrom();
  const auto note = [](double& to, double off, double whole) {
    if (off == 0) return;
    const double share = std::fabs(off) / whole;
    if (!(share <= to)) to = share;  // keeps a NaN
  };
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double radius = unit * grown_ball(balls.centres[i], balls.radii[i], alpha).grown_radius;
    note(most.ball_area, found.ball_area_angstrom2()[i] - expected.ball_area_angstrom2()[i],
         sphere_area(radius));
    note(most.ball_volume, found.ball_volume_angstrom3()[i] - expected.ball_volume_angstrom3()[i],
         ball_volume(radius));
  }
  return most;
}
bool same(const gpu::HostMeasures& a, const UnionMeasures& b) {
  bool equal = a.total == b.total;
  each_quantity([&](MeasuredQuantity q) {
    equal &= std::equal(a.of_ball[q].begin(), a.of_ball[q].end(), b.of_ball[q].begin(),
                        b.of_ball[q].end());
  });
  return equal;
}

// Medians of each column.
void print_times(const std::string& label, const std::vector<GpuMeasureTimes>& times) {
  const auto of = [&](const std::function<double(const GpuMeasureTimes&)>& column) {
    std::vector<double> values;
    for (const GpuMeasureTimes& t : times) values.push_back(column(t));
    return median(values);
  };
  std::printf("  %s: upload %.3f, kernels %.3f, download %.3f, whole %.3f ms (n = %zu)\n",
              label.c_str(), of([](auto& t) { return t.upload; }),
              of([](auto& t) { return t.kernels; }), of([](auto& t) { return t.download; }),
              of([](auto& t) { return t.whole; }), times.size());
  std::printf("    kernels:");
  const char* names[] = {"balls", "vertices", "edges", "triangles", "tetrahedra", "result"};
  for (int k = 0; k < 6; ++k) {
    std::printf(" %s %.3f;", names[k], of([&](auto& t) { return t.kernel[k]; }));
  }
  std::printf("\n");
}

class Molecule {
 public:
  Molecule(const std::string& file, const Options& options)
      : options_(options),
        balls_(with_solvent(bench::read_balls(file), options.solvent)),
        alpha_(balls_.lattice.alpha_on_lattice(options.alpha)),
        pipeline_(balls_),
        measurer_(make_gpu_measurer(nullptr)) {}

  // True when the device's numbers equal the CPU's.
  bool check() {
    const gpu::PipelineResult result = pipeline_.run(alpha_, false, {}, nullptr);
    if (!result.fits) throw std::runtime_error("beyond the device's kernels");
    complex_ = complex_of(result, balls_, alpha_);
    std::printf("  %zu balls, V %zu E %zu F %zu T %zu\n", balls_.size(), complex_.vertices.size(),
                complex_.edges.size(), complex_.triangles.size(), complex_.tetrahedra.size());
    measurer_->measure(balls_, complex_, sent_);
    const auto there = pipeline_.on_device();
    if (!there) throw std::runtime_error("the complex is not on the device");
    bool right = true;
    for (int n = 0; n < 3; ++n) {
      const bool equal = same(direct_.measure(*there, {}, nullptr), sent_);
      if (!equal) std::printf("  DIFFER: routes or runs %d\n", n);
      right = right && equal;
    }
    if (!options_.cpu) return right;
    UnionMeasures expected;
    cpu_.push_back(milliseconds_of([&] { expected = measure_union(balls_, complex_); }));
    const Differences off = differences(sent_, expected, balls_, alpha_);
    std::printf("  %s: area %.9f A2 (off %.1e), volume %.9f A3 (off %.1e), balls off %.1e, %.1e\n",
                off.are_small() ? "equal" : "DIFFER", sent_.area_angstrom2(), off.area,
                sent_.volume_angstrom3(), off.volume, off.ball_area, off.ball_volume);
    return right && off.are_small();
  }

  void time() {
    const int runs = options_.runs;
    std::vector<GpuMeasureTimes> sent, there;
    std::vector<double> alone, with;
    const auto run = [&] { pipeline_.run(alpha_, false, {}, nullptr); };
    const auto measure = [&](GpuMeasureTimes* times) {
      direct_.measure(*pipeline_.on_device(), {}, times);
    };
    for (int n = -3; n < runs; ++n) {  // three to warm up
      GpuMeasureTimes of_sent, of_there;
      measurer_->measure(balls_, complex_, sent_, {}, &of_sent);
      const double complex_alone = milliseconds_of(run);
      measure(&of_there);
      const double complex_and_measures = milliseconds_of([&] { run(), measure(nullptr); });
      if (n < 0) continue;
      sent.push_back(of_sent);
      there.push_back(of_there);
      alone.push_back(complex_alone);
      with.push_back(complex_and_measures);
    }
    print_times("there", there);
    print_times("sent", sent);
    std::printf("  complex %.3f, complex and measures (there) %.3f ms: %.3f more\n", median(alone),
                median(with), median(with) - median(alone));
    if (!options_.cpu) return;
    while (cpu_.size() < 11 && (cpu_[0] < 2000 || cpu_.size() < 3)) {
      cpu_.push_back(milliseconds_of([&] { measure_union(balls_, complex_); }));
    }
    std::printf("  CPU, all threads: %.3f ms (n = %zu)\n", median(cpu_), cpu_.size());
  }

 private:
  const Options& options_;
  const BallSet balls_;
  const LatticeAlpha alpha_;  // square lattice units
  gpu::DualEdgePipeline pipeline_;
  std::unique_ptr<GpuMeasurer> measurer_;
  gpu::UnionMeasurer direct_;
  AlphaComplex complex_;
  UnionMeasures sent_;
  std::vector<double> cpu_;
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int a = 1; a < argc; ++a) {
    const std::string word = argv[a];
    const auto number = [&] {
      if (++a >= argc) throw std::runtime_error(word + " needs a number");
      return std::stod(argv[a]);
    };
    if (word == "--solvent") {
      options.solvent = number();
    } else if (word == "--alpha") {
      options.alpha = number();
    } else if (word == "--runs") {
      options.runs = std::max(1, static_cast<int>(number()));
    } else if (word == "--no-cpu") {
      options.cpu = false;
    } else {
      options.files.push_back(word);
    }
  }
  if (options.files.empty()) throw std::runtime_error("no file; see measure_gpu_bench.cpp");
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = options_of(argc, argv);
    if (!gpu_device().usable) throw std::runtime_error(gpu_device().why_not);
    std::printf("%s\n", gpu_device().name.c_str());
    bool right = true;
    for (const std::string& file : options.files) {
      std::printf("%s, solvent %g A, alpha %g A2\n", file.c_str(), options.solvent, options.alpha);
      Molecule molecule(file, options);
      const bool equal = molecule.check();
      right = right && equal;
      if (equal) molecule.time();
      std::fflush(stdout);
    }
    return right ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
