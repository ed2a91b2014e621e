// SPDX-License-Identifier: GPL-3.0-or-later
// Compares pictures of the scene with earlier ones (tests/ui/baseline.hpp).
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/document/picture/picture_preset.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/amber_radii.hpp"
#include "tests/ui/baseline.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/scene/rod_picture.hpp"
#include "ui/scene/picture/frame_grab.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

struct Subject {
  std::string name;
  double alpha = 0;  // Å²
  PictureSettings settings;
};

// Makes a molecule so small that all drivers agree which of two faces is in front.
std::shared_ptr<const BallSet> molecule() {
  return testing::rod(5);
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  const auto add = [&all](const std::string& name, double alpha, auto change) {
    Subject subject{name, alpha, testing::plain_settings(molecule()->size(), 240, 160)};
    change(subject.settings);
    all.push_back(subject);
  };
  add("balls", 0, [](PictureSettings& o) {
    o.display.tetrahedra = false;
    o.display.ball_scale = 0.5f;
  });
  add("tetrahedra", 0, [](PictureSettings& o) {
    o.display.balls = false;
    o.display.shrink = 0.2f;
  });
  add("translucent", 0, [](PictureSettings& o) {
    o.display.complex_opacity = 0.35f;
    o.theme = Theme::light;
  });
  add("edges_and_triangles", -1.4, [](PictureSettings& o) {
    o.display.edges = o.display.triangles = true;
    o.display.ball_scale = 0.12f;
  });
  add("alpha_colours", 1, [](PictureSettings& o) {
    o.display.balls = false;
    o.display.complex_paint.by = ColourBy::alpha;
    o.options.legend = o.options.scale_bar = true;
    o.options.width = 360;  // a smaller picture has no room for the legend
    o.options.height = 240;
  });
  add("boundary_without_background", 0, [](PictureSettings& o) {
    o.display.tetrahedra = false;
    o.display.boundary = true;
    o.options.background.transparent = true;
  });
  add("cut_balls", 0, [](PictureSettings& o) {
    o.display.ball_scale = 1;
    o.clip = read_clip("view");
  });
  add("cut_tetrahedra", 2, [](PictureSettings& o) {
    o.display.balls = false;
    o.display.orthographic = true;
    o.clip = read_clip("1,0.3,0.2:4");
  });
  for (const DisplayPreset preset : kDisplayPresets) {
    if (is_for_use(preset)) continue;  // their pictures are as large as in print
    add(std::string("preset_") + preset_info(preset).id, 0,
        [&](PictureSettings& o) { o.display = with_preset(DisplaySettings(), preset); });
  }
  return all;
}

Image drawn(const Subject& subject) {
  const auto balls = molecule();
  const fs::path path = fs::temp_directory_path() /
                        ("alphascope_" + std::to_string(getpid()) + "_" + subject.name + ".png");
  testing::draw_carbons(balls, testing::complex_of(balls, subject.alpha), subject.settings, path);
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
