// SPDX-License-Identifier: GPL-3.0-or-later
// Times pictures:
//   alphascope_picture_bench FILE [ALPHA [WIDTH HEIGHT [OPACITY [OBJECTS [ASSEMBLY]]]]]
// ASSEMBLY is the number of one; alpha "none" leaves the complex out.
// Balls have 0.3 of their radius, beside tetrahedra, singular triangles and edges. The view turns
// slightly before each picture. Prints the least of several times in milliseconds.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/chain_colours.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/scene/objects/object_mesh.hpp"
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

double milliseconds_of(int times, const std::function<void()>& work) {
  std::vector<double> taken;
  for (int i = 0; i < times; ++i) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    taken.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun)
            .count());
  }
  std::sort(taken.begin(), taken.end());
  return taken[taken.size() / 2];
}

// Medians of the times until the objects can be drawn.
void show_objects(const PicturedMolecule& pictured, const char* text, Scene& scene) {
  constexpr int kTimes = 11;
  const ObjectListWords list = read_objects(text);
  if (!list.error.empty()) throw std::invalid_argument(list.error);
  std::shared_ptr<const ObjectFacts> facts;
  std::printf("  %-28s %8.1f ms\n", "secondary structure, bonds",
              milliseconds_of(kTimes, [&] { facts = find_object_facts(pictured); }));
  std::vector<SceneObject> objects;
  for (const DrawnObject& object : list.objects) {
    std::shared_ptr<const ObjectMesh> mesh;
    const double build = milliseconds_of(kTimes, [&] {
      mesh =
          std::make_shared<const ObjectMesh>(build_object(pictured, *facts, object, Appearance()));
    });
    objects.push_back({nullptr, object.opacity});
    const double arrays =
        milliseconds_of(kTimes, [&] { objects.back().data = make_object_data(mesh); });
    std::printf("  %-28s %8.1f ms, arrays %.1f ms; %zu triangles, %zu sticks, %zu balls\n",
                object_title(object).c_str(), build, arrays, mesh->cartoon.triangles(),
                mesh->sticks.rods.size(), mesh->spheres ? mesh->spheres->centres.size() : 0);
  }
  scene.set_objects(ObjectGroup::settings, std::move(objects));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: alphascope_picture_bench FILE [ALPHA [WIDTH HEIGHT [OPACITY [OBJECTS "
                 "[ASSEMBLY]]]]]\n");
    return 2;
  }
  const bool with_complex = argc < 3 || std::string(argv[2]) != "none";
  const double alpha = argc > 2 && with_complex ? std::atof(argv[2]) : 1;
  const int width = argc > 4 ? std::atoi(argv[3]) : 1280;
  const int height = argc > 4 ? std::atoi(argv[4]) : 800;
  const double opacity = argc > 5 ? std::atof(argv[5]) : 1;
  PicturedMolecule pictured;
  pictured.molecule = std::make_shared<const Molecule>(read_molecule(argv[1]));
  if (argc > 7) {
    pictured.molecule =
        std::make_shared<const Molecule>(expand_assembly(*pictured.molecule, argv[7]));
  }
  pictured.prepared = std::make_shared<const PreparedBalls>(prepare_balls(*pictured.molecule));
  const Molecule& molecule = *pictured.molecule;
  const PreparedBalls& prepared = *pictured.prepared;
  const auto geometry = std::make_shared<const BallGeometry>(*prepared.balls);
  const AlphaComplex complex =
      with_complex ? make_cpu_engine(prepared.balls)->compute({alpha, false}, {}) : AlphaComplex();
  const auto colours = colours_by_chain(molecule, prepared.atom_of_ball);
  MeshOptions options{.triangles = true, .edges = true};
  options.translucent = opacity < 1;
  const auto mesh =
      std::make_shared<const ComplexMesh>(build_mesh(*geometry, colours, complex, options));
  pictured.geometry = geometry;
  EglContext context;
  Scene scene;
  scene.set_balls(geometry, colours);
  BallStyle balls;
  balls.scale = 0.3;
  scene.set_ball_radii(drawn_radii(*geometry, balls));
  scene.set_mesh(make_mesh_data(mesh));
  if (argc > 6) show_objects(pictured, argv[6], scene);
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
