// SPDX-License-Identifier: GPL-3.0-or-later
// Times picking under the mouse, and making the boxes for it:
//   alphascope_pick_bench FILE [ALPHA [ASSEMBLY [all]]]
// Lines of sight go through all parts of a picture of the whole molecule. Times are of lines that
// hit something. "all": every face of every tetrahedron is drawn, as for translucent ones; else
// only outer faces.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/scene/camera.hpp"
#include "ui/scene/pick/pick.hpp"

namespace {

using namespace alphascope;
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<PickLine> lines_of_sight(const BallGeometry& balls) {
  constexpr int kAcross = 80, kDown = 50;
  const double aspect = 1.6, distance = fitting_distance(balls, {}, aspect);
  const double up = tangent_up(aspect, 0);
  std::vector<PickLine> lines;
  for (int i = 0; i < kAcross * kDown; ++i) {
    const double x = (2.0 * (i % kAcross) / kAcross - 1) * up * aspect;
    const double y = (1 - 2.0 * (i / kAcross) / kDown) * up;
    PickLine line;
    line.spread = 4 * 2 * up / 800;  // four of 800 pixels
    for (std::size_t k = 0; k < 3; ++k) {
      line.ray.start[k] = distance * balls.axes[2][k];
      line.ray.direction[k] = -balls.axes[2][k] + x * balls.axes[0][k] + y * balls.axes[1][k];
    }
    lines.push_back(line);
  }
  return lines;
}

// Returns the CPU time of this thread, which other programs hardly change.
double cpu_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

template <class Pick>
void report(const char* what, const std::vector<PickLine>& lines, const Pick& pick) {
  std::vector<double> times;
  for (const PickLine& line : lines) {
    const double start = cpu_milliseconds();
    const bool hit = pick(line);
    if (hit) times.push_back(cpu_milliseconds() - start);
  }
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  std::printf("  %-34s median %8.4f ms, 99 %% below %8.4f, most %8.4f; %zu of %zu hit\n", what,
              times[times.size() / 2], times[times.size() * 99 / 100], times.back(), times.size(),
              lines.size());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: alphascope_pick_bench FILE [ALPHA [ASSEMBLY [all]]]\n");
    return 2;
  }
  const double alpha = argc > 2 ? std::atof(argv[2]) : 0;
  const std::string assembly = argc > 3 ? argv[3] : "";
  Molecule molecule = read_molecule(argv[1]);
  if (!assembly.empty()) molecule = expand_assembly(molecule, assembly);
  const PreparedBalls prepared = prepare_balls(molecule);
  const auto geometry = std::make_shared<const BallGeometry>(*prepared.balls);
  const AlphaComplex complex = make_cpu_engine(prepared.balls)->compute({alpha, false}, {});
  MeshOptions options{.boundary = true, .triangles = true, .edges = true};
  options.translucent = argc > 4;
  const std::vector<Rgb8> colours(geometry->centres.size());
  auto start = Clock::now();
  const auto mesh =
      std::make_shared<const ComplexMesh>(build_mesh(*geometry, colours, complex, options));
  const double mesh_time = milliseconds_since(start);
  start = Clock::now();
  const PickLayers layers = mesh_layers(mesh, geometry);
  const double layers_time = milliseconds_since(start);
  start = Clock::now();
  const BallPicker picker(geometry);
  const double balls_time = milliseconds_since(start);
  std::printf(
      "%zu balls, %zu tetrahedra; mesh of %zu faces %.1f ms, its boxes %.1f ms, those of "
      "the balls %.1f ms\n",
      geometry->centres.size(), complex.tetrahedra.size(), mesh->faces_drawn(), mesh_time,
      layers_time, balls_time);
  const std::vector<float> radii = drawn_radii(*geometry, {});
  const double margin = picker.margin(radii);
  const std::vector<PickLine> lines = lines_of_sight(*geometry);
  report("balls, without boxes", lines,
         [&](const PickLine& line) { return pick_ball(*geometry, radii, line.ray).has_value(); });
  report("balls", lines,
         [&](const PickLine& line) { return picker.pick(radii, margin, line.ray).has_value(); });
  for (const PickLayer& layer : layers) {
    report(std::string(layer.id).c_str(), lines,
           [&](const PickLine& line) { return layer.pick(line).has_value(); });
  }
  report("all together", lines, [&](const PickLine& line) {
    return nearest_hit(layers, line).has_value() | picker.pick(radii, margin, line.ray).has_value();
  });
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "alphascope_pick_bench: %s\n", error.what());
  return 1;
}
