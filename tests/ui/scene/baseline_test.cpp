// Compares pictures of the scene with earlier ones (tests/ui/baseline.hpp).
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/document/settings/display_preset.hpp"
#include "tests/ui/baseline.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/picture/frame_grab.hpp"
#include "ui/scene/picture/screenshot.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

struct Subject {
  std::string name;
  double alpha = 0;  // Å²
  ScreenshotOptions options;
};

ScreenshotOptions small_picture() {
  ScreenshotOptions options;
  options.width = 240;
  options.height = 160;
  return options;
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  const auto add = [&all](const std::string& name, double alpha, auto change) {
    Subject subject{name, alpha, small_picture()};
    change(subject.options);
    all.push_back(subject);
  };
  add("balls", 0, [](ScreenshotOptions& o) {
    o.mesh.tetrahedra = false;
    o.balls.scale = 0.5;
  });
  add("tetrahedra", 0, [](ScreenshotOptions& o) {
    o.style.balls = false;
    o.mesh.shrink = 0.2;
  });
  add("translucent", 0, [](ScreenshotOptions& o) {
    o.style.complex_opacity = 0.35;
    o.style.theme = Theme::light;
  });
  add("edges_and_triangles", -1.4, [](ScreenshotOptions& o) {
    o.mesh.edges = o.mesh.triangles = true;
    o.balls.scale = 0.12;
  });
  add("alpha_colours", 1, [](ScreenshotOptions& o) {
    o.style.balls = false;
    o.mesh.colouring = ComplexColouring::alpha;
    o.scale_bar = true;
    o.width = 360;  // a smaller picture has no room for the legend
    o.height = 240;
  });
  add("boundary_without_background", 0, [](ScreenshotOptions& o) {
    o.mesh.tetrahedra = false;
    o.mesh.boundary = true;
    o.transparent = true;
  });
  add("cut_balls", 0, [](ScreenshotOptions& o) {
    o.balls.scale = 1;
    o.clip = read_clip("view");
  });
  add("cut_tetrahedra", 2, [](ScreenshotOptions& o) {
    o.style.balls = false;
    o.style.orthographic = true;
    o.clip = read_clip("1,0.3,0.2:4");
  });
  for (const DisplayPreset preset : kDisplayPresets) {
    add(std::string("preset_") + preset_info(preset).id, 0, [&](ScreenshotOptions& o) {
      const DisplayControls display = with_preset({}, preset);
      o.style = scene_style(display, Theme::dark);
      o.mesh = mesh_options(display, Theme::dark);
      o.balls = ball_style(display, nullptr);
    });
  }
  return all;
}

// So small that all drivers agree on which of two faces is in front.
std::shared_ptr<const BallSet> molecule() {
  return testing::rod(5);
}

Image drawn(const Subject& subject) {
  const auto balls = molecule();
  const fs::path path = fs::temp_directory_path() /
                        ("alphascope_" + std::to_string(getpid()) + "_" + subject.name + ".png");
  render_screenshot(*balls, testing::complex_of(balls, subject.alpha),
                    testing::two_colours(balls->size()), subject.options, path);
  Image image = testing::pixels_of(path);
  fs::remove(path);
  return image;
}

// Errors of an engine, drawn in front of the rest.
Image drawn_differences() {
  const auto balls = molecule();
  const auto geometry = std::make_shared<const BallGeometry>(*balls);
  const AlphaComplex complex = testing::complex_of(balls, 0);
  Comparison comparison;
  comparison.tetrahedra.missing.assign(complex.tetrahedra.simplices.begin(),
                                       complex.tetrahedra.simplices.begin() + 3);
  comparison.edges.extra = {{0, 79}, {3, 76}};
  EglContext context;
  Scene scene;
  scene.set_balls(geometry, testing::two_colours(balls->size()));
  scene.set_differences(make_difference_data(
      std::make_shared<const DifferenceMesh>(build_difference_mesh(*geometry, comparison))));
  return scene.grab(240, 160, false);
}

class Baseline : public ::testing::TestWithParam<Subject> {};

TEST_P(Baseline, PictureIsAsItWas) {
  testing::expect_like_baseline(GetParam().name, drawn(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Scene, Baseline, ::testing::ValuesIn(subjects()),
                         [](const auto& of) { return of.param.name; });

TEST(SceneBaseline, DifferencesAreDrawnAsTheyWere) {
  testing::expect_like_baseline("differences", drawn_differences());
}

}  // namespace
}  // namespace alphascope
