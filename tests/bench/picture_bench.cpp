// SPDX-License-Identifier: GPL-3.0-or-later
// Times pictures:
//   alphascope_picture_bench FILE [ALPHA [WIDTH HEIGHT [OPACITY]]]
// Balls have 0.3 of their radius, beside tetrahedra, singular triangles and edges. The view turns
// slightly before each picture. Prints the least of several times in milliseconds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/chain_colours.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace {

using namespace alphascope;

void turn(Scene& scene) {
  scene.pointer_move(100, 100, false, false);
  scene.pointer_button(PointerButton::left, true);
  scene.pointer_move(106, 102, false, false);
  scene.pointer_button(PointerButton::left, false);
}

void report(const char* what, Scene& scene, int times, const std::function<double()>& draw) {
  std::vector<double> taken;
  for (int i = 0; i < times; ++i) {
    turn(scene);
    taken.push_back(draw());
  }
  std::sort(taken.begin(), taken.end());
  std::printf("  %-28s %8.1f ms\n", what, taken.front());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: alphascope_picture_bench FILE [ALPHA [WIDTH HEIGHT [OPACITY]]]\n");
    return 2;
  }
  const double alpha = argc > 2 ? std::atof(argv[2]) : 1;
  const int width = argc > 4 ? std::atoi(argv[3]) : 1280;
  const int height = argc > 4 ? std::atoi(argv[4]) : 800;
  const double opacity = argc > 5 ? std::atof(argv[5]) : 1;
  const Molecule molecule = read_molecule(argv[1]);
  const PreparedBalls prepared = prepare_balls(molecule);
  const auto geometry = std::make_shared<const BallGeometry>(*prepared.balls);
  const AlphaComplex complex = make_cpu_engine(prepared.balls)->compute({alpha, false}, {});
  const auto colours = colours_by_chain(molecule, prepared.atom_of_ball);
  MeshOptions options{.triangles = true, .edges = true};
  options.translucent = opacity < 1;
  const auto mesh =
      std::make_shared<const ComplexMesh>(build_mesh(*geometry, colours, complex, options));
  EglContext context;
  Scene scene;
  scene.set_balls(geometry, colours);
  BallStyle balls;
  balls.scale = 0.3;
  scene.set_ball_radii(drawn_radii(*geometry, balls));
  scene.set_mesh(make_mesh_data(mesh));
  SceneStyle style;
  style.complex_opacity = opacity;
  style.depth_cue = 0.4f;
  style.outlines = 1.5f;
  style.samples = kMostSamples;
  scene.set_style(style);
  std::printf("%zu balls, %zu tetrahedra, %zu faces in the mesh, %d x %d\n",
              geometry->centres.size(), complex.tetrahedra.size(), mesh->faces_drawn(), width,
              height);
  const auto render = [&](RenderQuality quality) { return scene.render(width, height, quality); };
  render(RenderQuality::draft);
  report("sketch", scene, 7, [&] { return render(RenderQuality::sketch); });
  report("draft", scene, 7, [&] { return render(RenderQuality::draft); });
  report("medium", scene, 5, [&] { return render(RenderQuality::medium); });
  report("one sample of a fine one", scene, 5, [&] { return render(RenderQuality::fine); });
  report("fine", scene, 1, [&] {
    double sum = 0;
    for (int k = 0; k < kMostSamples; ++k) sum += render(RenderQuality::fine);
    return sum;
  });
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "alphascope_picture_bench: %s\n", error.what());
  return 1;
}
